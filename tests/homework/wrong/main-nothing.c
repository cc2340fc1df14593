// Wrong: draws and forgets to write.
// Expect: no picture was written
// Stage: depth
#include "solutions/homework/raytracer.h"

#define image_write(img, path) (void)0
#include "solutions/homework/main.c"
