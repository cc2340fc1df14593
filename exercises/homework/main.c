// Your ray tracer. The task is in README.md, beside this file; everything else is yours.
