/* Scenes that a reference does not cover. Each is the scene of a page of `cases` with one change, so that exactly one
 * condition of the reference is violated.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "report/outcome.h"
#include "suites.h"
#include "written.h"

/* The first occurrence of `old` on the page becomes `new`. The reference refuses the first run with a message that
 * contains `words`, or covers it if `words` is NULL. */
struct changed {
  const char *old, *new, *words;
};

/* The text of the page. The caller frees it. */
static char *page_text(const char *page) {
  char path[4096];
  snprintf(path, sizeof path, "%s/cases/%s.md", NB_SRCDIR, page);
  FILE *file = fopen(path, "r");
  CU_ASSERT_PTR_NOT_NULL_FATAL(file);
  char *text = calloc(1, 1 << 16);
  CU_ASSERT_PTR_NOT_NULL_FATAL(text);
  const size_t length = fread(text, 1, (1 << 16) - 1, file);
  CU_ASSERT(length > 0 && length < (1 << 16) - 1);
  fclose(file);
  return text;
}

/* True if the change occurs on the page and the reference solves or refuses the scene as expected. */
static bool as_expected(const char *text, const struct changed *change, struct nb_outcome *outcome) {
  char path[] = "/tmp/nineball-refuses-XXXXXX";
  const char *at = strstr(text, change->old);
  if (!at) {
    printf("# not on the page: %s\n", change->old);
    return false;
  }
  FILE *file = written_file(path);
  fprintf(file, "%.*s%s%s", (int)(at - text), text, change->new, at + strlen(change->old));
  fclose(file);
  nb_outcome_read(outcome, path, NULL);
  unlink(path);
  if (outcome->status != NB_OK) {
    printf("# %s", outcome->mistakes.text);
    return false;
  }
  struct nb_solution solution = {0};
  struct nb_error error = {0};
  const struct nb_page_run *run = &outcome->runs[0];
  const enum nb_status status = nb_reference_solve(run->expectations.reference, &solution, &run->scene, &error);
  solution_free(&solution);
  if (change->words ? status == NB_BAD_USE && strstr(error.text, change->words) : status == NB_OK)
    return true;
  printf("# %s -> %s: %d %s\n", change->old, change->new, status, error.text);
  return false;
}

static void check(const char *page, const struct changed *changes, size_t count) {
  char *text = page_text(page);
  for (size_t k = 0; k < count; k++) {
    struct nb_outcome outcome;
    const bool right = as_expected(text, &changes[k], &outcome);
    if (!right)
      printf("# %s\n", page);
    CU_ASSERT(right);
    nb_outcome_free(&outcome);
  }
  free(text);
}
#define PAGE(page, ...)                                                                                                \
  do {                                                                                                                 \
    static const struct changed changes[] = {__VA_ARGS__};                                                             \
    check(page, changes, sizeof changes / sizeof *changes);                                                            \
  } while (0)

static void numerics(void) {
  PAGE("5-numerics/fracc", {"disc      1e-6 0", "disc 9 0 radius 0.1 m\ndisc      1e-6 0", "one disc"},
       {"wall      west ", "wall more 9 9 to 10 9 m\nwall      west ", "one disc"},
       {"(h/sqrt(2)) of single-contact", "0.1", "`step F of"},
       {"cycles    60", "cycles    60\nstage more\ncycles 60", "one disc"},
       {"disc      1e-6 0", "disc      1e-6 1e-9", "one disc"}, {"velocity 0 $vy", "velocity 1e-9 0", "one disc"},
       {"wall      west   -0.9 -5 to -0.9 5  m", "material n kn 2\nwall      west   -0.9 -5 to -0.9 5  n",
        "one stiffness"},
       {"wall      north  -5 $high to 5 $high  m", "material n kn 2\nwall      north  -5 $high to 5 $high  n",
        "one stiffness"});
  PAGE("5-numerics/fracc-touch", {"step      $share", "disc 9 9 radius 1 m\nstep      $share", "two equal discs"},
       {"velocity 1 0", "velocity -1 0", "head-on"}, {"velocity 1 0", "velocity 0 0 spin 0", "head-on"},
       {"velocity 1 0", "velocity 1 1e-9", "head-on"},
       {"disc      1.0314 0  radius 1  m", "disc      1.0314 0  radius 1  m velocity 0.1 0", "head-on"},
       {"disc      1.0314 0  radius 1  m", "disc      1.0314 0  radius 0.9999  m", "two equal discs"},
       {"disc      1.0314 0  radius 1  m", "disc      1.0314 0  radius 1.0001  m", "two equal discs"},
       {"disc      1.0314 0  radius 1  m", "disc      1.0314 1e-9  radius 1  m", "head-on"},
       {"disc      1.0314 0  radius 1  m", "material n density (1/pi) kn 1\ndisc      1.0314 0  radius 1  n",
        "two equal discs"},
       {"$share of single-contact", "0.001", "`step F of"});
  PAGE(
      "5-numerics/rayleigh-mean",
      {"sphere    0 mm 5 mm ", "material m density 1 g/cm3 young 1 GPa poisson 0.2\nsphere 0 mm 5 mm ", "one material"},
      {"velocity $speed 0 m/s", "velocity -$speed 0 m/s", "collide along x"},
      {"sphere    $gap 5 mm ", "sphere    0.6 mm 5 mm ", "collide along x"},
      {"sphere    $gap 5 mm ", "sphere    $gap 5.001 mm ", "collide along x"},
      {"sphere    $gap 5 mm ", "sphere    $gap 4.999 mm ", "collide along x"},
      {"velocity $speed 0 m/s", "velocity $speed 1 mm/s", "collide along x"},
      {"radius 0.3 mm  steel\nlattice", "radius 0.3 mm  steel velocity 0 m/s -1 mm/s\nlattice", "collide along x"},
      {"$share of rayleigh-fit-mean", "$share of rayleigh-fit", "rayleigh-fit-mean"},
      {"at most 10000 cycles", "at most 5 cycles", "within the 5 cycles"});
  PAGE("5-numerics/changed-law",
       {"wall      floor", "sphere 1 m 1 m radius 1 mm glass\nwall      floor", "one sphere and one wall"},
       {"wall      floor", "wall far 9 m 9 m to 8 m 9 m glass\nwall      floor", "one sphere and one wall"},
       {"to 50 mm 0 mm  glass", "to 50 mm 0 mm  glass about 0 mm 1 mm",
        "does not cover `wall about a point off its line`"},
       {"sphere    0 mm 9.999 mm", "sphere    0 mm 10.001 mm", "does not slide"},
       {"velocity 1 mm/s 0 mm/s", "velocity 1 mm/s 1e-9 mm/s", "tangentially"},
       {"stage     hertz", "stage     hertz\nstep 0.1 of stable", "given as times"},
       {"stage     hertz", "stage     hertz\nwall floor velocity 2 mm/s 0 mm/s", "constant velocity"},
       {"friction 0.3", "friction 0.03", "does not slide"}, {"density 1e20 kg/m3", "density 1e9 kg/m3", "so heavy"});
}

static void one_particle(void) {
  PAGE("1-two-discs/cohesion", {"wall      low ", "disc 1 m 1 m radius 1 mm clay\nwall      low ", "one disc"},
       {"monitor   L", "wall more 1 m 1 m to 2 m 1 m plate\nmonitor   L", "one disc"},
       {"low   velocity 2 mm/s 0", "low   velocity 3 mm/s 0", "press, shear"},
       {"high  velocity 2 mm/s 0 mm/s", "high  velocity 2 mm/s 1 mm/s", "press, shear"},
       {"2 mm/s 0 mm/s\n  wall    high  velocity 2 mm/s", "0 mm/s 0 mm/s\n  wall    high  velocity 0 mm/s",
        "press, shear"},
       {"0 mm/s 10 mm/s", "0 mm/s 0.9 mm/s", "leave the disc"}, {"0 mm/s 10 mm/s", "0 mm/s 1.1 mm/s", NULL},
       {"smooth  kn 10 MN/m", "smooth  kn 10 MN/m  ks 8 MN/m  friction 0.1", "neither friction nor cohesion"},
       {"normal    linear", "pair clay smooth cohesion 1 N\nnormal    linear", "neither friction nor cohesion"});
  PAGE("1-two-discs/free-fall",
       {"wall      floor", "sphere 9 m 9 m radius 1 mm rock\nwall      floor", "one particle and one wall"},
       {"wall      floor", "wall far 9 m 9 m to 8 m 9 m rock\nwall      floor", "one particle and one wall"},
       {"to 1 m 0 m", "to 1 m 1 mm", "a wall along x"},
       {"sphere    0 m 0.5 m", "sphere    0 m -0.5 m", "below the particle"},
       {"gravity   0 m/s2", "gravity   0.001 m/s2", "dropped straight down"},
       {"sphere    0 m 0.5 m", "sphere    0 m 0.0999 m", "above the wall"},
       {"damping   ratio (-log(e)/sqrt(log(e)^2 + pi^2))", "damping   ratio 1.01", "less than critical"},
       {"damping   ratio (-log(e)/sqrt(log(e)^2 + pi^2))", "damping   ratio 0.99", NULL},
       {"0.0004 of single-contact", "0.001 of stable", "a step given as a time"});
  PAGE("1-two-discs/many-bounces", {"gravity   0 m/s2", "gravity   0.001 m/s2", "dropped straight down"},
       {"sphere    0 m $h", "sphere    0 m 0.0999 m", "from rest"},
       {"0 m/s2 -$g", "0 m/s2 $g", "dropped straight down"},
       {"damping   ratio (-log(e)/sqrt(log(e)^2 + pi^2))", "damping   ratio 1.01", "less than critical"},
       {"damping   ratio (-log(e)/sqrt(log(e)^2 + pi^2))", "damping   ratio 0.999", "leaves the wall again"});
  PAGE("1-two-discs/incline", {"20 deg 33 deg", "33 deg", NULL},
       {"stage     run", "stage     run\ngravity 0 m/s2 -$g", NULL},
       {"20 deg 33 deg", "33 deg\nlet flat = 0 m/s2", NULL});
  PAGE(
      "1-two-discs/rotation-off", {"wall      floor", "disc 5 m 5 m radius 1 mm rock\nwall      floor", "one particle"},
      {"wall      floor", "wall far 9 m 9 m to 8 m 9 m plate\nwall      floor", "one particle"},
      {"to 9 m 0 m", "to 9 m 1 mm", "level floor"},
      {"wall      floor  -1 m 0 m to 9 m 0 m", "wall      floor  -1 m 0.2 m to 9 m 0.2 m", "level floor"},
      {"gravity   0 m/s2 ", "gravity   0.001 m/s2 ", "level floor"},
      {"gravity   0 m/s2 -$g", "gravity   0 m/s2 $g", "under gravity"},
      {"velocity 2 m/s 0 m/s", "velocity -2 m/s 0 m/s", "moves in +x"},
      {"velocity 2 m/s 0 m/s", "velocity 2 m/s 1 mm/s", "moves in +x"},
      {"friction 0.4", "kn 5 MN/m", "friction of the pair"},
      {"friction 0.4", "friction 0.4 ks 5 MN/m", "friction of the pair"},
      {"friction 0.4", "friction 0.4 kn 5 MN/m", "friction of the pair"},
      {"friction 0.4", "friction 0.4 cohesion 1 N", "cohesion"}, {"friction 0.4", "friction 0", "friction of the pair"},
      {"  pair    rock plate  friction 0.4", "  material rock friction 0.1", "friction of the pair"},
      {"step      50 us", "step 0.1 of stable", "a step given as a time"},
      {"spin 30 rad/s", "spin -30 rad/s", "contact point that moves in +x"},
      {"C.sliding below 0.5", "C.sliding above 0.5",
       "the reference `rotation_off` is for stages that end with `until C.sliding below X`"},
      {"C.sliding below 0.5", "C.shear below 0.5 N", "`until C.sliding below X`"},
      {"C.sliding below 0.5", "time below 5 s", "`until C.sliding below X`"},
      {"C.sliding below 0.5", "C.sliding below 0.5 and time above 0 s", "`until C.sliding below X`"});
  PAGE("1-two-discs/slide-to-roll", {"gravity   0 m/s2 ", "gravity   0.001 m/s2 ", "along the floor"},
       {"to 9 m 0 m", "to 9 m 1 mm", "a wall along x"},
       {"velocity $u0 0 m/s", "velocity $u0 1 mm/s", "along the floor"},
       {"velocity $u0 0 m/s", "velocity -$u0 0 m/s", "along the floor"},
       {"let       y = R - m*g/kn", "let       y = R - 1.0002*m*g/kn", "equal to its weight"},
       {"let       y = R - m*g/kn", "let       y = R - 0.9998*m*g/kn", "equal to its weight"},
       {"let       y = R - m*g/kn", "let       y = R - 1.00005*m*g/kn", NULL},
       {"mu  0.1 0.3 1", "mu  1000 1", "that slides"},
       {"damping   ratio 0.2", "damping   ratio 0.6", "critical damping"});
  PAGE("1-two-discs/wedge",
       {"wall      left", "disc 9 m 9 m radius 1 mm iron\nwall      left", "one particle and two walls"},
       {"wall      left", "wall far 9 m 9 m to 8 m 9 m iron\nwall      left", "one particle and two walls"},
       {"gravity   0 m/s2 -$g", "gravity   -9.9 m/s2 -$g", "rests on"},
       {"gravity   0 m/s2 -$g", "gravity   9.9 m/s2 -$g", "rests on"},
       {"(-long*sin(A)) (long*cos(A))", "(-0.9*R*sin(A)) (0.9*R*cos(A))", "rests on"},
       {"(long*sin(B)) (long*cos(B))", "(0.9*R*sin(B)) (0.9*R*cos(B))", "rests on"});
  PAGE("1-two-discs/turning-wall",
       {"wall      blade", "disc 9 m 9 m radius 1 mm iron\nwall      blade", "one particle and one wall"},
       {"wall      blade", "wall far 9 m 9 m to 8 m 9 m iron\nwall      blade", "one particle and one wall"},
       {"velocity 0.9 m/s 0.01 m/s  spin 1", "velocity 0.91 m/s 0.01 m/s  spin 1", "turns with the wall"},
       {"velocity 0.9 m/s 0.01 m/s  spin 1", "velocity 0.9 m/s 0.02 m/s  spin 1", "turns with the wall"},
       {"velocity 0.9 m/s 0.01 m/s  spin 1", "velocity 0.9 m/s 0.01 m/s  spin 1.1", "turns with the wall"},
       {"radius 0.1 m  iron", "radius 0.11 m  iron", "just touches"},
       {"radius 0.1 m  iron", "radius 0.09 m  iron", "just touches"},
       {"stage     round", "stage     round\nwall blade spin 1 rad/s", "whose motion no stage changes"},
       {"step      $dt", "step 0.1 of stable", "a step given as a time"},
       {"friction 0.5", "friction 0.1", "does not slide"}, {"to 1 m -1 m", "to 0.8 m -1 m", "does not reach its end"},
       {"disc      0.01 m", "disc      -0.01 m", "turns with the wall"});
}

static void impacts(void) {
  PAGE("5-numerics/glancing-discs", {"step      $h", "step      0.1 of stable", "a step given as a time"},
       {"friction 0  cohesion 1e200", "friction 0  cohesion 1", "does not slide"},
       {"monitor   A", "disc 9 9 radius 1 steel\nmonitor   A", "two particles, or"});
  PAGE("5-numerics/order", {"stage     strike", "stage     strike\nwall floor velocity 0.1 0", "no stage changes"},
       {"friction 1e9", "friction 0.1", "does not slide"},
       {"to 9 0  steel", "to 0.01 0  steel", "does not reach its end"},
       {"-9 0  to 9 0  steel", "-0.001 0  to 9 0  steel", "does not reach its end"},
       {"n  0.002 60", "n  0.002 9000", "opens only with an undeformed"});
  PAGE("7-assemblies/pinched-sphere", {"V  10 mm/s 30", "V  0 mm/s 30", "approach each other"},
       {"monitor   P", "sphere 1 m 1 m radius $r glass\nmonitor   P", "spheres of one material"},
       {"sphere    -$X", "material m density 1 g/cm3 young 1 GPa poisson 0.2\nsphere    -$X", "of one material"},
       {"-$X 0 mm  radius $R  glass  velocity $V 0 m/s   fixed", "-$X 0 mm  radius $R  glass  velocity $V 0 m/s",
        "fixed ones"},
       {"velocity -$V 0 m/s  fixed", "velocity -$V 0 m/s", "fixed ones"},
       {"radius $r  glass", "radius $r  glass fixed", "at rest between"},
       {"$X 0 mm   radius $R", "$X 0 mm   radius (1.001*R)", "two equal"},
       {"$X 0 mm   radius", "(X + 1 nm) 0 mm   radius", "along x"},
       {"velocity -$V 0", "velocity (-0.999*V) 0", "approach each other"},
       {"velocity $V 0 m/s   fixed\nsphere    $X 0 mm   radius $R  glass  velocity -$V",
        "velocity -$V 0 m/s   fixed\nsphere    $X 0 mm   radius $R  glass  velocity $V", "approach each other"},
       {"sphere    0 mm $Y", "sphere    1 nm $Y", "between them"},
       {"radius $r  glass", "radius $r  glass velocity 1 um/s 0 m/s", "at rest"},
       {"radius $r  glass", "radius $r  glass velocity 0 m/s 1 um/s", "at rest"}, {"-$X 0 mm", "-$X 1 nm", "along x"},
       {"$X 0 mm   radius", "$X 1 nm   radius", "along x"},
       {"sphere    0 mm $Y", "sphere    0 mm -$Y", "above the line"},
       {"velocity $V 0 m/s ", "velocity $V 1 um/s ", "along x"},
       {"velocity -$V 0 m/s", "velocity -$V 1 um/s", "along x"});
  PAGE("4-oblique/oblique-impact-forces", {"friction 0.12", "friction 0", "a contact with friction"},
       {"stage     strike", "stage strike\nwall floor velocity 0 m/s 0 m/s", "no stage changes"});
  PAGE("8-published/mfix-dem-05", {"35 deg 40 deg", "20 deg 40 deg", "impact.psi1 >= 4 chi"},
       {"35 deg 40 deg", "0 deg 40 deg", NULL}, {"ks 14.8 MN/m\nmaterial  alloy", "\nmaterial alloy", "with friction"},
       {"friction 0.092  kn 17.2 MN/m  ks 14.8 MN/m\nnormal", "kn 17.2 MN/m ks 14.8 MN/m\nnormal", "with friction"},
       {"damping   ratio $beta", "damping ratio 1", "below critical damping"},
       {"stage     strike", "stage strike\nwall plate velocity 0 m/s 0 m/s", "no stage changes"});
  PAGE("4-oblique/closed-squares-r89", {"slip by -$slip ", "slip by (-2*slip) ", "in turns, without"},
       {"out     slip by $slip ", "out     slip by (12*slip) ", "in turns, without"},
       {"out     slip by $slip ", "out     shear to 1 N hold normal ", "in turns, without"},
       {"out     slip by $slip ", "out     normal to $N slip by $slip ", "in turns, without"},
       {"segment  press   normal to $N ", "segment  press   overlap to -1 um ", "in turns, without"},
       {"out     slip by $slip ", "out     slip by -$slip ", "in turns, without"},
       {"slip by -$slip ", "slip by (-0.9*slip) ", NULL});
  PAGE("4-oblique/closed-squares", {"out     slip by 0.25 um", "out     slip by 2 um", "a path without sliding"},
       {"out     slip by 0.25 um", "out     slip by -2 um", "a path without sliding"},
       {"out     slip by 0.25 um", "out     slip by 0.2 um", NULL});
  PAGE("4-oblique/oblique-impact-rigid",
       {"monitor   C", "sphere 1 m 1 m radius 1 mm steel\nmonitor   C", "one particle and one wall"},
       {"monitor   C", "wall far 1 m 1 m to 2 m 1 m steel\nmonitor   C", "one particle and one wall"});
  PAGE("4-oblique/oblique-impact-phase",
       {"stage     strike", "stage     strike\nwall floor velocity 0 m/s 0 m/s", "no stage changes"});
  PAGE("2-hertz/hertz-impact-wall",
       {"monitor   C", "wall far 1 m 1 m to 2 m 1 m steel\nmonitor   C", "another sphere or a wall"});
  PAGE("8-published/chung-ooi-1",
       {"monitor   C", "sphere 1 m 1 m radius 1 mm $of\nmonitor   C", "another sphere or a wall"},
       {"0.01 of collision", "0.1 of rayleigh", "duration of the collision"});
  PAGE("8-published/mfix-dem-03", {"gravity   0 m/s2", "gravity   0.1 m/s2", "vertical gravity"},
       {"-2 mm 0 mm    to 2 mm 0 mm ", "-2 mm 0 mm    to 2 mm 0.01 mm ", "two horizontal walls"},
       {"1.35 mm  radius 0.5 mm  light", "1.35 mm  radius 0.5 mm  light velocity 0 m/s -1 m/s", NULL},
       {"monitor   A", "sphere 9 m 9 m radius 1 mm light\nmonitor   A", "two spheres"},
       {"monitor   A", "wall far 9 m 9 m to 8 m 9 m light\nmonitor   A", "two spheres"},
       {"sphere    0 mm 1.35 mm", "sphere    0.001 mm 1.35 mm", "vertically below"},
       {"-2 mm 0 mm    to 2 mm 0 mm ", "0.01 mm 0 mm to 2 mm 0 mm ", "two horizontal walls"},
       {"-2 mm 0 mm    to 2 mm 0 mm ", "-2 mm 0 mm    to 2 mm -0.01 mm ", "two horizontal walls"},
       {"-2 mm 1.8 mm  to 2 mm 1.8 mm ", "-2 mm 1.8 mm  to 2 mm 1.79 mm ", "two horizontal walls"},
       {"-2 mm 0 mm    to 2 mm 0 mm ", "2 mm 0 mm to -0.01 mm 0 mm ", NULL},
       {"-2 mm 0 mm    to 2 mm 0 mm ", "-2 mm 0 mm to -0.01 mm 0 mm ", "two horizontal walls"},
       {"-2 mm 1.8 mm  to 2 mm 1.8 mm ", "2 mm 1.8 mm to 0.01 mm 1.8 mm ", "two horizontal walls"},
       {"-2 mm 1.8 mm  to 2 mm 1.8 mm ", "-0.01 mm 1.8 mm to 2 mm 1.8 mm ", NULL});
}

static void lattices(void) {
  PAGE("6-lattices/literal-continuum", {"per cycle\n", "per cycle shear 1e-7 per cycle\n", "along the axes"},
       {"per cycle\n", "per cycle c12 1e-7 per cycle\n", "along the axes"},
       {"per cycle\n", "per cycle c21 1e-7 per cycle\n", "along the axes"},
       {"affine strain 1e-6 per cycle -1e-6 per cycle\n", "affine strain 1e-6 1/s -1e-6 1/s\n", "per cycle"},
       {"per cycle\n", "per cycle accumulated\n", "last stage only"},
       {"stage     shear", "stage more\n  affine strain 1e-6 per cycle -1e-6 per cycle\n  cycles 1\nstage     shear",
        "one stage or two"},
       {"  affine strain 1e-6 per cycle -1e-6 per cycle\n", "", "an `affine strain`"});
  PAGE("6-lattices/force-chain", {"discs 5 by 1", "discs 1 by 1", "a row of discs"},
       {"region    A", "wall more 90 90 to 91 91 m\nregion    A", "two walls"},
       {"lattice ", "disc 9 9 radius 1 m\nlattice ", "equal discs"},
       {"discs 5 by 1  from 0.95 0  radius 1  spacing 1.95  m",
        "discs 4 by 1  from 0.95 0  radius 1  spacing 1.95  m\ndisc 8.75 0 radius 1.001 m", "equal discs"},
       {"discs 5 by 1  from 0.95 0  radius 1  spacing 1.95  m",
        "discs 4 by 1  from 0.95 0  radius 1  spacing 1.95  m\nmaterial n density 1 kn 1000\ndisc 8.75 0 radius 1 n",
        "equal discs"},
       {"discs 5 by 1  from 0.95 0  radius 1  spacing 1.95  m",
        "discs 4 by 1  from 0.95 0  radius 1  spacing 1.95  m\ndisc 8.75 0 radius 1 m", NULL},
       {"west  0 -1     to 0 1 ", "west  0.001 -1     to 0.001 1 ", "normal to the row"},
       {"west  0 -1     to 0 1 ", "west  0 -1     to 0.001 1 ", "normal to the row"},
       {"east  9.70 -1  to 9.70", "east  9.71 -1  to 9.71", "normal to the row"});
  PAGE("6-lattices/force-chain", {"discs 5 by 1  from 0.95 0  radius 1  spacing 1.95  m\nwall      west  0 -1     to 0 "
                                  "1     m\nwall      east  9.70 -1  to 9.70 1 ",
                                  "discs 2 by 1  from 0.95 0  radius 1  spacing 1.95  m\nwall      west  0 -1     to 0 "
                                  "1     m\nwall      east  3.85 -1  to 3.85 1 ",
                                  NULL});
  PAGE("6-lattices/chain-wave",
       {"disc      0.99 0  radius 1  m  velocity 0.001 0\nlattice   discs 99 by 1  from 2.98 0  radius 1  spacing 1.99 "
        " m\nwall      west  0 -1       to 0 1       m\nwall      east  198.99 -1  to 198.99 1 ",
        "disc      1.01 0  radius 1  m  velocity 0.001 0\nlattice   discs 99 by 1  from 3.02 0  radius 1  spacing 2.01 "
        " m\nwall      west  0 -1       to 0 1       m\nwall      east  201.01 -1  to 201.01 1 ",
        "the same overlap"},
       {"monitor   A", "wall more 9 9 to 8 9 m\nmonitor   A", "two walls"},
       {"disc      0.99 0  radius", "disc      0.99 1e-9  radius", "a straight row"},
       {"velocity 0.001 0", "velocity 0.001 1e-9", "a straight row"},
       {"disc      0.99 0  radius 1 ", "disc      0.99 0  radius 1.0001 ", "equal particles"},
       {"disc      0.99 0  radius 1  m", "material n density (1/pi) kn 1\ndisc      0.99 0  radius 1  n",
        "equal particles"},
       {"disc      0.99 0 ", "sphere    0.99 0 ", "equal particles"},
       {"wall      west  0 -1       to 0 1       m", "material n kn 2\nwall      west  0 -1       to 0 1       n",
        "walls as stiff"},
       {"wall      east  198.99 -1  to 198.99 1  m", "material n kn 2\nwall      east  198.99 -1  to 198.99 1  n",
        "walls as stiff"},
       {"198.99 -1  to 198.99 1", "198.98 -1  to 198.98 1", "the same overlap"},
       {"west  0 -1       to 0 1 ", "west  0 0       to 0.1 1 ", "the same overlap"},
       {"east  198.99 -1  to 198.99 1", "east  198.99 0  to 198.9 1", "the same overlap"},
       {"0.1 of single-contact", "0.1 of stable", "a step given as a time"}, {"0.1 of single-contact", "0.1", NULL});
  PAGE("6-lattices/lattice-moduli",
       {"cell    strain -1e-3 -1e-3", "cell    strain -1e-3 -1e-3 c12 1e-4", "without rotation"},
       {"lattice   discs", "disc 0.5 0.5 radius 0.1 glass\nlattice   discs", "equal particles"},
       {"step      1e-3", "step 0.1 of stable", "steps given as times"},
       {"shear     linear", "shear     none", "linear springs"},
       {"from 1 1  radius 1  spacing $s", "from 1 1  radius 0.9  spacing $s", "touches four or six"});
  PAGE("6-lattices/lattice-hertz", {"shear     none", "shear     linear", "or elastic spheres without shear"},
       {"normal    hertz", "normal    linear",
        "the reference `lattice_moduli` is for linear springs, or elastic spheres without shear"},
       {"(10*sqrt(3)) mm", "(10.001*sqrt(3)) mm", "a lattice that fills the cell"});
  PAGE("6-lattices/ring-strain-literal",
       {"step      0.01", "damping con1 0.9 as all\nstep 0.01", "for `accumulated` without damping"},
       {"sphere    3 2     radius 1  m", "sphere    3 2     radius 1  m velocity 1e-9 0",
        "for `accumulated` without damping"});
  PAGE("1-two-discs/two-wall-statics",
       {"wall      east   200 0  to 200 100", "wall      east   900 0  to 900 100", "with one wall behind each"},
       {"wall      west   0 0    to 0 100 ", "wall      west   -900 0  to -900 100 ", "with one wall behind each"},
       {"normal    linear",
        "pair x plate ks 1e9 friction 0.5\nwall low 0 0 to 200 0 plate\nnormal linear\nshear linear",
        "exert no shear force"},
       {"normal    linear", "pair x plate ks 1e9 friction 0\nwall low 0 0 to 200 0 plate\nnormal linear\nshear linear",
        NULL},
       {"disc      150 50 ", "disc      900 50 ", "with one wall behind each"},
       {"walls     stop\n", "", "stage rest moves them until a condition holds"},
       {"velocity -0.12 0", "velocity -0.12000001 0", "equal speeds"},
       {"0.05 of single-contact", "0.05 of stable", "as a time or as a fraction"});
  PAGE("5-numerics/step-limit", {"box       0 0 to $w $h", "box -9 -9 to 99 99", NULL},
       {"lattice   discs $nx by $ny  radius 1  rock\n", "disc 5 1 radius 0.5 rock\n", "there are no contacts"},
       {"lattice   discs $nx by $ny  radius 1  rock\n", "lattice discs 40 by 26 from -300 -300 radius 1 rock\n",
        "up to 1000 particles, not for 1040"},
       {"lattice   discs $nx by $ny  radius 1  rock\n",
        "disc 5 1 radius 0.5 rock fixed\ndisc 5.9 1 radius 0.5 rock fixed\n", "there are no contacts"});
  PAGE("../tests/variants/three-discs-statics", {"reference  nine_discs_statics", "reference  nine_discs_slip", NULL},
       {"friction 4", "friction 0.1", "do not slip; the contact of particle 1 with particle 2 slips at cycle"});
  PAGE("6-lattices/lattice-waves", {"stage     oscillate", "stage more\ncycles 1\nstage     oscillate", "one stage"},
       {"lattice   discs", "disc 0.5 0.5 radius 0.1 glass\nlattice   discs", "equal particles"},
       {"friction 1e9", "friction 1e5", "at least 1e6"},
       {"from 1 1  radius 1  spacing", "from 1 1  radius 0.99998  spacing", "overlaps four or six"},
       {"perturb wave  $vx $vy  periods $nx $ny", "perturb wave  $vx $vy  periods $nx $ny\ndisc 1 1 radius 1 glass",
        "lattice"});
  PAGE("6-lattices/ring-strain", {"cycles    500", "cycles    500\nstage more\ncycles 1", "for one stage"},
       {"affine strain 1e-3 per cycle -1e-3 per cycle  shear 4e-4",
        "affine strain 1.1e-3 per cycle -1e-3 per cycle  shear 4e-4", "the same symmetric strain"},
       {"affine strain 1e-3 per cycle -1e-3 per cycle  shear 4e-4",
        "affine strain 1e-3 per cycle -1.1e-3 per cycle  shear 4e-4", "the same symmetric strain"},
       {"affine strain 1e-3 per cycle -1e-3 per cycle  shear 4e-4",
        "affine strain 1e-3 per cycle -1e-3 per cycle  shear 3e-4", "the same symmetric strain"},
       {"step      0.01", "step 0.1 of stable", "a step given as a time"},
       {"damping   con1 0.98 as cs79\n", "", "if particles have velocities"},
       {"shear 4e-4 per cycle\n  cycles", "shear 4e-4 per cycle accumulated\n  cycles", "for `accumulated` without"});
  PAGE("6-lattices/servo-lattice", {"to 19.999 mm 19.999 mm", "to 19.999 mm 20.999 mm", "a square lattice"},
       {"step      1 us", "step 0.1 of stable", "a step given as a time"},
       {"shear 0.015 1/s", "c12 0.015 1/s", "without rotation"},
       {"radius 1 mm  spacing", "radius 1.0001 mm  spacing", NULL},
       {"at most 0.03 1/s", "at most 0.03 per cycle", "at rates in 1/s"},
       {"cell    strain -0.01 1/s -0.02 1/s  shear 0.015 1/s", "cell    strain -0.01 per cycle -0.02 per cycle",
        "at rates in 1/s"});
}

static void assemblies(void) {
  PAGE("7-assemblies/fill-tries",
       {"monitor   G", "sphere 1 m 1 m radius 1 mm glass\nmonitor   G", "no other particles"},
       {"fill      spheres circle 0 mm 0 mm radius $R  $which glass  seed $seed  attempts $tries  else skip",
        "fill spheres circle 1 m 0 mm radius $R  $which glass  seed $seed  attempts $tries  else skip\nfill spheres "
        "circle 0 mm 0 mm radius $R  $which glass  seed $seed  attempts $tries  else skip",
        "one `fill`"});
  PAGE("6-lattices/lattice-stress", {"region    A", "disc 50 0 radius 0.1 m\nregion    A", "lattice"},
       {"lattice   discs 10 by 1  from 0 0               radius 1 ",
        "lattice   discs 10 by 1  from 0 0.001               radius 1 ", "lattice"},
       {"lattice   discs 10 by 1  from $x1 $h            radius 1 ",
        "lattice   discs 10 by 1  from (x1 + 0.001) $h            radius 1 ", "lattice"},
       {"lattice   discs 10 by 1  from $x1 $h            radius 1 ",
        "lattice   discs 10 by 1  from $x1 $h            radius 1.001 ", "lattice"},
       {"(2.3 + 4*a)", "(2.3 + 3.5*a)", "boxes of whole cells"},
       {"(2.7 + 2*h)", "(2.7 + 1.5*h)", "boxes of whole cells"});
  PAGE("6-lattices/box-servo",
       {"stage     rest", "stage more\nwalls stop\ncycles 1\nstage     rest", "by `box strain` and"},
       {"stage     mean\n", "stage     mean\nbox strain 1e-9 per cycle 2e-9 per cycle\n", "alone"},
       {"stage     mean\n", "stage     mean\nbox strain 1e-9 per cycle 1e-9 per cycle\n", NULL},
       {"lattice   discs 4 by 3  radius 10 mm  rock",
        "lattice   discs 4 by 3  radius 10 mm  rock\ndisc 10 mm 9 mm radius 1 mm rock", "one `lattice discs`"},
       {"strain 0 per cycle -1e-6 per cycle", "strain 0 1/s -1e-6 1/s", "alone"},
       {"box       0 mm 0 mm to 80 mm 60 mm  rock", "material soft kn 2 MN/m\nbox       0 mm 0 mm to 80 mm 60 mm  soft",
        "of the same stiffness"});
  PAGE(
      "3-nine-discs/speed-of-loading", {"lattice   discs 3 by 3", "lattice   discs 3 by 2", "nine equal discs"},
      {"monitor   C", "wall far 900 900 to 800 900 rock\nmonitor   C", "in a box"},
      {"walls     inward $v", "walls     inward $v\nwall east velocity 0 0", "equal speeds"},
      {"walls     inward $v",
       "wall south velocity 0 $v\nwall north velocity 0 -$v\nwall west velocity $v 0\nwall east velocity -$v 0", NULL},
      {"walls     inward $v",
       "wall south velocity 0 $v\nwall north velocity 0 -$v\nwall west velocity $v 0\nwall east velocity $v 0",
       "approach"},
      {"walls     inward $v",
       "wall south velocity 0 $v\nwall north velocity 0 -$v\nwall west velocity $v 0\nwall east velocity (-1.0001*v) 0",
       "equal speeds"},
      {"walls     inward $v", "wall south velocity 0 $v\nwall north velocity 0 -$v\nwall west velocity $v 0",
       "from the first stage"},
      {"lattice   discs 3 by 3  radius 50  rock",
       "lattice   discs 3 by 2  radius 50  rock\nlattice discs 2 by 1 from 50 250 radius 50 rock\ndisc 250 250 radius "
       "49 rock",
       "nine equal discs"},
      {"lattice   discs 3 by 3  radius 50  rock",
       "material m density 1000 kn 1.35e9\nlattice   discs 3 by 2  radius 50  rock\nlattice discs 2 by 1 from 50 250 "
       "radius 50 rock\ndisc 250 250 radius 50 m",
       "nine equal discs"},
      {"box       0 0 to 300 300  rock", "material hard kn 2e9\nbox 0 0 to 300 300 hard", "a box of the same material"},
      {"0.1 of single-contact", "0.1 of stable", "a step given as a time or as"},
      {"0.1 of single-contact", "0.001", NULL}, {"cycles    $n", "cycles    100", "longer than 20/alpha"});
  PAGE("6-lattices/stress-ring",
       {"boundary  circle", "sphere 0.1 mm 0 mm radius 1 nm glass\nboundary  circle", "six spheres"},
       {"sphere    -$d2 0 mm    radius $R2", "sphere    -$d2 0 mm    radius (1.001*R2)", "of two sizes in turn"},
       {"sphere    -$x1 -$y1    radius $R1", "sphere    -$x1 -$y1    radius (1.001*R1)", "of two sizes in turn"},
       {"sphere    -$x1 -$y1    radius $R1  glass",
        "material m density 2650 kg/m3  young 70 GPa  poisson 0.25\nsphere    -$x1 -$y1    radius $R1  m",
        "of two sizes in turn"},
       {"stress 100 kPa 100 kPa", "stress 100 kPa 101 kPa", "an isotropic boundary"},
       {"stress 100 kPa 100 kPa", "stress 100 kPa 100 kPa shear 1 kPa", "an isotropic boundary"});
  PAGE("5-numerics/time-reversal",
       {"  reverse velocities\n", "  reverse velocities\n  wall east velocity 0 0\n", "only in the first stage"},
       {"  reverse velocities\n  cycles  8000", "  reverse velocities\n  cycles  8001", "as many cycles"},
       {"  cycles  8000\n", "  cycles  8000\nstage more\nreverse velocities\ncycles 1\n", "one `reverse velocities`"});
  PAGE("1-two-discs/taken-out", {"stage     row\n", "stage     row\nremove disc 3\n", "of which only the second"},
       {"cycles    $n\nstage     gone\nremove    disc 2\nremove    disc 4\nremove    wall gate\n",
        "remove    wall gate\ncycles    $n\nstage     gone\nremove    disc 2\nremove    disc 4\n",
        "of which only the second"},
       {"stage     gone\n", "stage more\ncycles 1\nstage     gone\n", "two stages"},
       {"step      $h", "step      0.1 of stable", "given as a time"});
  PAGE("8-published/mfix-dem-03",
       {"sphere    0 mm 0.45 mm  radius 0.5 mm  heavy",
        "sphere    0 mm 0.45 mm  radius 0.5 mm  heavy velocity 1 mm/s 0 m/s", "without horizontal velocity"},
       {"sphere    0 mm 1.35 mm  radius 0.5 mm  light",
        "sphere    0 mm 1.35 mm  radius 0.5 mm  light velocity 1 mm/s 0 m/s", "without horizontal velocity"},
       {"to 2 mm 0 mm ", "to 2 mm 0.001 mm ", "two horizontal walls"},
       {"-2 mm 0 mm    to 2 mm 0 mm ", "-2 mm 0.46 mm to 2 mm 0.46 mm ", "first the floor"},
       {"sphere    0 mm 0.45 mm", "sphere    0 mm 1.36 mm", "vertically below"},
       {"-2 mm 1.8 mm  to 2 mm 1.8 mm ", "-2 mm 1.3 mm  to 2 mm 1.3 mm ", "then the ceiling"},
       {"to 2 mm 1.8 mm ", "to 2 mm 1.801 mm ", "two horizontal walls"});
  PAGE("6-lattices/force-chain-turn",
       {"lattice   discs 1 by 3  from 0 mm $Y  radius 10 mm  spacing $Y  steel\nlattice   discs 1 by 4  from $x $y  "
        "radius 10 mm  spacing $Y  steel",
        "disc $x $y radius 10 mm steel\ndisc 0 mm $Y radius 10 mm steel", "three or more free discs"},
       {"lattice   discs 1 by 3  from 0 mm $Y  radius 10 mm  spacing $Y  steel\nlattice   discs 1 by 4  from $x $y  "
        "radius 10 mm  spacing $Y  steel",
        "disc $x $y radius 10 mm steel\ndisc 0 mm $Y radius 10 mm steel\ndisc $x (3*y) radius 10 mm steel", NULL},
       {"region    A  all", "region    A  circle 0 m 0 m radius 1 mm", NULL},
       {"discs 1 by 2  from 100 mm 0 mm  radius 10 mm  spacing 30 mm  steel",
        "discs 2 by 1  from 100 mm 0 mm  radius 10 mm  spacing 19 mm  steel", "the same angle with y"});
  PAGE("1-two-discs/two-wall-statics",
       {"monitor   A", "disc 900 900 radius 1 x\nmonitor   A", "two particles in a row"},
       {"velocity 0.12 0", "velocity 0.13 0", "equal speeds"},
       {"velocity -0.12 0", "velocity 0.12 0", "approach with equal speeds"});
  PAGE("4-oblique/nested-loops",
       {"shear to 16 N    hold normal", "shear to 16 N    normal to 89 N",
        "the reference `mindlin_loops` is for a normal force that is constant once there is shear"});
}

void suite_refs_refuses(void) {
  CU_pSuite suite = CU_add_suite("refs_refuses", NULL, NULL);
  CU_add_test(suite, "cases about numerics", numerics);
  CU_add_test(suite, "one particle", one_particle);
  CU_add_test(suite, "impacts", impacts);
  CU_add_test(suite, "lattices", lattices);
  CU_add_test(suite, "several particles", assemblies);
}
