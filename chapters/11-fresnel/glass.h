// glass.h: paths through glass: nested media, metals, and the path tracer for them.
#ifndef CHAPTER_GLASS_H
#define CHAPTER_GLASS_H

#include "chapters/11-fresnel/fresnel.h"

typedef enum {
    OPAQUE, // chapter 10's surface: Lambert, GGX, lamps
    GLASS,  // a smooth boundary of a body that light passes through
    METAL,  // a smooth conductor
} kind;

typedef struct {
    kind kind;
    real n;             // GLASS: its index, 1 to 4
    color sigma;        // GLASS: what it absorbs, per unit of length
    int priority;       // GLASS: where two bodies overlap, the higher one is there
    const metal *metal; // METAL
} substance;

typedef struct {
    lit_room room;               // places, opaque surfaces (one for each body), lamps
    const substance *substances; // one for each body
} glass_room;

// The glass bodies that a path is inside of, at most MEDIA_MAX; what is nested deeper is not seen.
enum { MEDIA_MAX = 8 };
typedef struct {
    int count;
    int body[MEDIA_MAX];
} media;

// The body whose medium is at hand: of those in `in` the one with the highest priority, of
// equals the one entered last; -1: air.
int media_now(const media *in, const substance *of);

// The bodies after passing the boundary of `body`, inwards or outwards.
media media_pass(media in, int body, bool inwards);

// A path_tracer for glass rooms. Rays start in air. A boundary between two bodies
// that does not separate what is at hand (the weaker of an overlap) is passed as if it
// were not there, and is no bounce. Source: Schmidt and Budge 2002.
color glass_trace(const glass_room *sc, ray r, int s, rng *g);

#endif
