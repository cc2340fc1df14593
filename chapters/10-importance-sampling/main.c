// 10-importance-sampling: the box of chapter 09 with directions chosen where the light is;
// the strategies side by side, the scene by Veach, metals from smooth to rough.
#include <stdio.h>

#include "chapters/10-importance-sampling/scenes.h"
#include "common/measure.h"

typedef struct {
    lit_room room;
    int s; // bounces at most
} job;

static color look(const void *data, ray r, rng *g) {
    const job *j = data;
    return light_trace(&j->room, r, j->s, g);
}

static image draw(const options *opt, const camera *cam, scene bodies, const surface *surfaces,
                  strategy how) {
    job j = {lit(bodies, surfaces, how), opt->depth};
    const image img = render("10-importance-sampling", cam, look, &j, opt);
    lit_free(&j.room);
    return img;
}

// ---- the box -------------------------------------------------------------------------

static const real ball_alpha = (real)0.2;

static image show_box(const options *opt, strategy how) {
    surface surfaces[BOX_BODIES];
    fill_box_surfaces(surfaces, ball_alpha);
    const camera cam = box_camera(opt->width, opt->height);
    return draw(opt, &cam, box_bodies, surfaces, how);
}

// The time of a sample in percent of one of BY_POWER, measured: the others get so many more
// samples. Fixed here, so that the picture is the same everywhere.
static const struct {
    const char *name;
    strategy how;
    int percent;
} contest[] = {
    {"uniform", BY_UNIFORM, 67},
    {"BRDF", BY_BRDF, 67},
    {"lamps", BY_LAMPS, 100},
    {"both", BY_POWER, 100},
};

static double rmse(const image *a, const image *b) {
    running square = {0};
    for (int i = 0; i < a->width * a->height; i++) {
        const vec3 off = sub(a->pixels[i], b->pixels[i]);
        running_add(&square, (double)dot(off, off) / 3);
    }
    return sqrt(square.mean);
}

enum { REFERENCE = 32 }; // times the samples of a part

// Equal times side by side; below the names their errors.
static image show_strategies(const options *opt) {
    options of = *opt;
    of.width = image_part_width(opt->width, 0, COUNT(contest));
    of.samples = REFERENCE * opt->samples, of.seed = opt->seed + 1;
    image truth = show_box(&of, BY_POWER), parts[COUNT(contest)];
    of.seed = opt->seed;
    for (int i = 0; i < COUNT(contest); i++) {
        of.samples = (opt->samples * 100 + 50) / contest[i].percent;
        parts[i] = show_box(&of, contest[i].how);
        printf("%-8s %4d samples: RMSE %.4f\n", contest[i].name, of.samples,
               rmse(&parts[i], &truth));
    }
    image_free(&truth);
    return image_side_by_side(parts, COUNT(parts));
}

// ---- other scenes ----------------------------------------------------------------------

static image show_plates(const options *opt) {
    static const strategy ways[] = {BY_LAMPS, BY_BRDF, BY_POWER};
    veach_plates v;
    const scene bodies = veach_build(&v);
    const camera cam = veach_camera(image_part_width(opt->width, 0, COUNT(ways)), opt->height);
    image thirds[COUNT(ways)];
    for (int i = 0; i < COUNT(ways); i++)
        thirds[i] = draw(opt, &cam, bodies, v.surfaces, ways[i]);
    return image_side_by_side(thirds, COUNT(thirds));
}

static image show_row(const options *opt) {
    const camera cam = row_camera(opt->width, opt->height);
    return draw(opt, &cam, row_bodies, row_surfaces, BY_POWER);
}

// ---- the program -----------------------------------------------------------------------

static const choice pictures[] = {
    {"box", "the box of chapter 09, lamps and BRDF together by the power heuristic"},
    {"uniform", "the same by uniform directions, as in chapter 09"},
    {"brdf", "the same by directions where the surfaces send most"},
    {"lamps", "the same by points of the lamps"},
    {"both", "the same by both, balance heuristic"},
    {"strategies", "uniform, BRDF, lamps, both: in the same time; prints their errors"},
    {"plates", "the scene by Veach: lamps, BRDF, both"},
    {"ggx", "copper, from nearly smooth to rough"},
    {0},
};

static image show(const options *opt) {
    if (shows(opt, "uniform")) return show_box(opt, BY_UNIFORM);
    if (shows(opt, "brdf")) return show_box(opt, BY_BRDF);
    if (shows(opt, "lamps")) return show_box(opt, BY_LAMPS);
    if (shows(opt, "both")) return show_box(opt, BY_BALANCE);
    if (shows(opt, "strategies")) return show_strategies(opt);
    if (shows(opt, "plates")) return show_plates(opt);
    if (shows(opt, "ggx")) return show_row(opt);
    return show_box(opt, BY_POWER);
}

int main(int argc, char **argv) {
    const program about = {
        .name = "10-importance-sampling",
        .summary = "Draws the box of 09-path-tracer with directions chosen where the light is.",
        .uses = USES_SIZE | USES_SAMPLES | USES_DEPTH | USES_SEED | USES_THREADS | USES_PREVIEW,
        .defaults = {.width = 400,
                     .height = 400,
                     .samples = 64,
                     .depth = 16,
                     .seed = 1,
                     .out = "10-importance-sampling.png"},
        .shows = pictures,
    };
    const options opt = options_parse(argc, argv, &about);
    image img = show(&opt);
    image_write(&img, opt.out);
    image_free(&img);
}
