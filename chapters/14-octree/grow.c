// grow.c: from a heap of triangles to a tree, level by level.
#include <limits.h>
#include <string.h>

#include "chapters/14-octree/cell.h"
#include "chapters/14-octree/heap.h"

const octree_options octree_defaults = {.leaf_size = 4, .depth = OCTREE_DEPTH, .memory = 16};

// ---- a level ---------------------------------------------------------------------------

// A cell of the level that is being divided.
typedef struct {
    int node;
    long from, count; // its triangles in the level's list
    aabb cell;
} open_cell;

typedef struct {
    heap cells, list; // open_cell; int, triangles
} level;

typedef struct {
    const mesh *m;
    octree_options how;
    long most; // nodes, and entries of lists
    heap nodes, lists;
    heap met; // of a cell's triangles: masks of children, unsigned char
} grower;

static void make_leaf(grower *g, const open_cell *c, const int *triangles) {
    octree_node *n = (octree_node *)g->nodes.at + c->node;
    *n = (octree_node){(int)g->lists.count, (int)c->count};
    if (!c->count) return;
    memcpy(heap_more(&g->lists, c->count), triangles, (size_t)c->count * sizeof *triangles);
}

// A mask of the children that T meets, given that it meets the cell. Where its box lies on one
// side of each plane that is the child; else the candidates are asked.
static unsigned children_met(triangle T, aabb cell) {
    const aabb box = aabb_of(T);
    const vec3 m = cell_middle(cell);
    const int low = (box.min.x <= m.x) | (box.min.y <= m.y) << 1 | (box.min.z <= m.z) << 2,
              high = (box.max.x >= m.x) | (box.max.y >= m.y) << 1 | (box.max.z >= m.z) << 2;
    if (!(low & high)) return 1u << high;
    unsigned mask = 0;
    for (int i = 0; i < 8; i++) {
        const bool near = (i & ~high) == 0 && (~i & 7 & ~low) == 0;
        if (near && cell_overlaps(T, cell_child(cell, i))) mask |= 1u << i;
    }
    return mask;
}

// Notes for each triangle which children it meets; how many meet child i: inside[i].
static void sort_out(grower *g, const open_cell *c, const int *triangles, int inside[8]) {
    g->met.count = 0;
    unsigned char *met = heap_more(&g->met, c->count);
    for (int i = 0; i < 8; i++) inside[i] = 0;
    for (long k = 0; k < c->count; k++) {
        met[k] = (unsigned char)children_met(mesh_triangle(g->m, triangles[k]), c->cell);
        for (int i = 0; i < 8; i++) inside[i] += met[k] >> i & 1;
    }
}

// A child's cell, to be divided with the next level, and a node that will be filled in then.
static void open_child(grower *g, const open_cell *c, int i, const int *triangles, int inside,
                       level *next) {
    const unsigned char *met = g->met.at;
    const open_cell child = {(int)g->nodes.count, next->list.count, inside,
                             cell_child(c->cell, i)};
    *(open_cell *)heap_more(&next->cells, 1) = child;
    *(octree_node *)heap_more(&g->nodes, 1) = (octree_node){0};
    for (long k = 0; k < c->count; k++)
        if (met[k] >> i & 1) *(int *)heap_more(&next->list, 1) = triangles[k];
}

// Is there a number between each two opposite sides?
static bool has_inside(aabb cell) {
    const vec3 m = cell_middle(cell);
    return cell.min.x < m.x && m.x < cell.max.x && cell.min.y < m.y && m.y < cell.max.y &&
           cell.min.z < m.z && m.z < cell.max.z;
}

// May a cell be divided, and is it worth it? `waiting`: entries that the rest of the level
// brings into the lists, at least.
static bool divides(grower *g, const open_cell *c, int depth, const int *triangles,
                    long waiting, int inside[8]) {
    static const int nothing[8] = {0};
    if (depth >= OCTREE_DEPTH || !has_inside(c->cell)) return false;
    // Not even if all children were empty: no need to look which triangle meets which child.
    if (!worth_dividing(g->how, depth, (int)c->count, nothing)) return false;
    sort_out(g, c, triangles, inside);
    for (int i = 0; i < 8; i++) waiting += inside[i];
    return g->lists.count + waiting <= g->most && g->nodes.count + 8 <= g->most &&
           worth_dividing(g->how, depth, (int)c->count, inside);
}

static void grow_cell(grower *g, const open_cell *c, int depth, const int *triangles,
                      long waiting, level *next) {
    int inside[8], mask = 0;
    if (!divides(g, c, depth, triangles, waiting + next->list.count, inside)) {
        make_leaf(g, c, triangles);
        return;
    }
    const int first = (int)g->nodes.count;
    for (int i = 0; i < 8; i++) {
        if (!inside[i] && !g->how.dense) continue;
        mask |= 1 << i;
        open_child(g, c, i, triangles, inside[i], next);
    }
    ((octree_node *)g->nodes.at)[c->node] = (octree_node){first, -mask};
}

static void grow_level(grower *g, const level *now, int depth, level *next) {
    next->cells.count = next->list.count = 0;
    for (long k = 0; k < now->cells.count; k++) {
        const open_cell c = ((open_cell *)now->cells.at)[k];
        grow_cell(g, &c, depth, (int *)now->list.at + c.from,
                  now->list.count - c.from - c.count, next);
    }
}

// ---- before and after --------------------------------------------------------------------

// What is within the range of numbers: a side may not be infinite.
static real side_end(real low, real side, real high) {
    return lesser(greater(low + side, high), REAL_MAX);
}

static aabb cube_around(aabb box) {
    const real side =
        greater(box.max.x - box.min.x, greater(box.max.y - box.min.y, box.max.z - box.min.z));
    return (aabb){box.min,
                  {side_end(box.min.x, side, box.max.x), side_end(box.min.y, side, box.max.y),
                   side_end(box.min.z, side, box.max.z)}};
}

// The triangles that can be hit; returns their box.
static aabb keep_triangles(const mesh *m, heap *list) {
    aabb box = aabb_empty;
    for (int i = 0; i < m->count; i++) {
        const triangle T = mesh_triangle(m, i);
        if (!is_finite(T.p1) || !is_finite(T.p2) || !is_finite(T.p3) || !triangle_has_area(T))
            continue;
        *(int *)heap_more(list, 1) = i;
        box = aabb_join(box, aabb_of(T));
    }
    return box;
}

octree octree_build(const mesh *m, octree_options how) {
    octree o = {.m = m, .how = how};
    level now = {{.size = sizeof(open_cell)}, {.size = sizeof(int)}}, next = now;
    o.cube = cube_around(keep_triangles(m, &now.list));
    grower g = {m, how, 0, {.size = sizeof(octree_node)}, {.size = sizeof(int)}, {.size = 1}};
    const long most = how.memory * now.list.count + 64;
    g.most = most < INT_MAX / 2 ? most : INT_MAX / 2;
    if (now.list.count > 0) {
        *(octree_node *)heap_more(&g.nodes, 1) = (octree_node){0};
        *(open_cell *)heap_more(&now.cells, 1) = (open_cell){0, 0, now.list.count, o.cube};
    }
    for (int depth = 0; now.cells.count > 0; depth++) {
        grow_level(&g, &now, depth, &next);
        const level swap = now;
        now = next;
        next = swap;
    }
    free(now.cells.at), free(now.list.at), free(next.cells.at), free(next.list.at),
        free(g.met.at);
    o.nodes = g.nodes.at, o.node_count = (int)g.nodes.count;
    o.lists = g.lists.at, o.entry_count = (int)g.lists.count;
    return o;
}

void octree_free(octree *o) {
    free(o->nodes);
    free(o->lists);
    *o = (octree){0};
}
