// todo.h: a stub says what is missing and returns something harmless.
#ifndef COMMON_TODO_H
#define COMMON_TODO_H

// Notes that `what`, the name of an exercise, is not written yet. A program says
// so once per place, on stderr; a test reports `todo`. Safe from any thread.
#define TODO(what) todo_note(what, __FILE__, __LINE__)

void todo_note(const char *what, const char *file, int line);

// What was noted first, or NULL when nothing was.
const char *todo_first(void);

#endif
