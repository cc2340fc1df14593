// balance_heuristic: two ways to the same light. The task is in README.md.
#include "chapters/10-importance-sampling/importance.h"
#include "common/todo.h"

real balance_heuristic(real p, real q) {
    TODO("balance_heuristic"); // your answer instead of these two lines
    return 1;
}
