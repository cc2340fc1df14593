// glass.h: paths through glass: nested media, metals, and the path tracer for them.
#ifndef CHAPTER_GLASS_H
#define CHAPTER_GLASS_H

#include "chapters/11-fresnel/fresnel.h"

typedef enum {
    OPAQUE, // chapter 10's surface: Lambert, GGX, lamps
    GLASS, // a smooth boundary of a body that light passes through; a plane bounds all behind it
    METAL, // a smooth conductor
} kind;

typedef struct {
    kind kind;
    real n;             // GLASS: its index, 1 to 4
    color sigma;        // GLASS: what it absorbs, per unit of length
    int priority;       // GLASS: where bodies overlap, the one with the highest is there
    const metal *metal; // METAL
} substance;

// The glass bodies that a path is inside of, at most MEDIA_MAX; what is nested deeper is
// not seen.
enum { MEDIA_MAX = 8 };
typedef struct {
    int count;
    int body[MEDIA_MAX];
} media;

typedef struct {
    lit_room room;               // places, opaque surfaces (one for each body), lamps
    const substance *substances; // one for each body
    media start;                 // what the rays start in; {0}: air
} glass_room;

// The body whose medium is at hand: of those in `in` the one with the highest priority, of
// equals the one entered last; -1: air.
int media_now(const media *in, const substance *of);

// The bodies after passing the boundary of `body`, inwards or outwards.
media media_pass(media in, int body, bool inwards);

// A path_tracer for glass rooms: the radiance that arrives along r, in the medium that it
// starts in. A boundary with the same index on both sides (as that of the weaker of two
// bodies that overlap) is passed as if it were not there, and is no bounce. Faces that coincide
// must be made to overlap a little. Source: Schmidt and Budge 2002.
color glass_trace(const glass_room *sc, ray r, int s, rng *g);

#endif
