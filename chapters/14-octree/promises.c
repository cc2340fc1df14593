// promises.c: does a tree keep what octree.h says of it?
#include "chapters/14-octree/cell.h"

typedef struct {
    const octree *o;
    const char *flaw;
} inspection;

static bool meets(aabb cell, aabb box) {
    return cell.min.x <= box.max.x && box.min.x <= cell.max.x && cell.min.y <= box.max.y &&
           box.min.y <= cell.max.y && cell.min.z <= box.max.z && box.min.z <= cell.max.z;
}

static void inspect_leaf(inspection *x, const octree_node *n, aabb cell) {
    const octree *o = x->o;
    if (n->count == 0 && !o->how.dense && n != o->nodes) x->flaw = "a leaf is empty";
    if (n->first < 0 || n->first > o->entry_count - n->count) {
        x->flaw = "a leaf's list lies outside the array";
        return;
    }
    for (int k = n->first; k < n->first + n->count; k++) {
        const int i = o->lists[k];
        if (i < 0 || i >= o->m->count) {
            x->flaw = "a list names a triangle that is none";
            return;
        }
        if (k > n->first && o->lists[k - 1] >= i) x->flaw = "a list is not in rising order";
        if (!meets(cell, aabb_of(mesh_triangle(o->m, i))))
            x->flaw = "a triangle is in a leaf that it is far from";
    }
}

static void inspect(inspection *x, int node, aabb cell, int depth) {
    const octree_node *n = &x->o->nodes[node];
    if (depth > x->o->how.depth) x->flaw = "a leaf is deeper than how.depth";
    if (x->flaw) return;
    if (is_leaf(n)) {
        inspect_leaf(x, n, cell);
        return;
    }
    int child = n->first;
    for (int i = 0; i < 8 && !x->flaw; i++) {
        if (!is_stored(stored_children(n), i)) continue;
        if (child <= node || child >= x->o->node_count) {
            x->flaw = "a child does not stand behind its parent";
            return;
        }
        inspect(x, child++, cell_child(cell, i), depth + 1);
    }
}

static bool lists(const octree *o, const octree_node *leaf, int number) {
    for (int k = leaf->first; k < leaf->first + leaf->count; k++)
        if (o->lists[k] == number) return true;
    return false;
}

// Is the triangle in the list of each leaf whose closed cell holds p, one of its corners?
static bool found_at(const octree *o, const octree_node *n, aabb cell, vec3 p, int number) {
    if (is_leaf(n)) return lists(o, n, number);
    const octree_node *child = &o->nodes[n->first];
    for (int i = 0; i < 8; i++) {
        const aabb part = cell_child(cell, i);
        const bool stored = is_stored(stored_children(n), i);
        if (meets(part, (aabb){p, p}) && !(stored && found_at(o, child, part, p, number)))
            return false;
        child += stored;
    }
    return true;
}

const char *octree_flaw(const octree *o) {
    inspection x = {.o = o};
    if (o->node_count) inspect(&x, 0, o->cube, 0);
    for (int i = 0; i < o->m->count && !x.flaw; i++) {
        const triangle T = mesh_triangle(o->m, i);
        if (!is_finite(T.p1) || !is_finite(T.p2) || !is_finite(T.p3) || !triangle_has_area(T))
            continue;
        if (!o->node_count || !found_at(o, o->nodes, o->cube, T.p1, i) ||
            !found_at(o, o->nodes, o->cube, T.p2, i) ||
            !found_at(o, o->nodes, o->cube, T.p3, i))
            x.flaw = "a triangle is not in every leaf that holds one of its corners";
    }
    return x.flaw;
}
