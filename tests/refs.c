/* Functions that all references share: solutions, the list of references, scenes that are refused.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "../src/core/model.h"
#include "../src/laws/law.h"
#include "refs_scenes.h"
#include "report/outcome.h"
#include "suites.h"
#include "written.h"

static const double kn = 1.35e9;

static void scenes_outside_the_theory_are_refused(void) {
  struct refs_scene it;
  refs_nine_discs(&it, kn, 2, 40, 400);
  it.stages[1].damping.contact_kind = NB_CONTACT_STIFFNESS;
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("nine_discs", &it).text, "damping"));
  struct nb_solution solution = refs_solution("nine_discs_statics", &it); /* damping does not change the equilibrium */
  solution_free(&solution);
  refs_nine_discs(&it, kn, 2, 40, 400);
  it.stages[1].step.value = 0.05;
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("nine_discs", &it).text, "step in a stage"));
  refs_nine_discs(&it, kn, 2, 40, 400);
  it.scene.step.value = it.stages[0].step.value = it.stages[1].step.value = 0.3; /* the fastest mode's limit is 0.267 */
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("nine_discs", &it).text, "too long"));
  refs_nine_discs(&it, kn, 2, 40, 400);
  for (size_t i = 0; i < 4; i++)
    it.motions[i].vx *= -1, it.motions[i].vy *= -1;
  CU_ASSERT_STRING_EQUAL(refs_refused("nine_discs_statics", &it).text,
                         "this reference is for contacts that stay closed; the contact of particle 1 with particle 2 "
                         "opens at cycle 440");
  CU_ASSERT_STRING_EQUAL(refs_refused("nine_discs_slip", &it).text,
                         "this reference is for contacts that stay closed; the contact of particle 1 with particle 2 "
                         "opens at cycle 440");
  it.materials[0].cohesion = 1;
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("nine_discs_slip", &it).text, "cohesion"));
  refs_nine_discs(&it, kn, 2, 40, 400);
  it.particles[4].x += 0.01;
  /* disc 2 is below disc 5: the gap is (100^2 + 0.01^2)^(1/2) - 100 */
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("nine_discs_statics", &it).text,
                                "just touch: the gap between particle 2 and particle 5 is 5e-07 m; it must be 0"));
  refs_nine_discs(&it, kn, 2, 40, 400);
  it.walls[3].x += 1e-6; /* west: it overlaps disc 1 */
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("nine_discs_statics", &it).text,
                                "the gap between particle 1 and wall 4 is -1e-06 m; it must be 0"));
  /* Without sliding, S has the forces (9/14, 5/14) k_n d, see nine_discs_statics.c, and disc 1 has S as its second
   * contact; disc 1 with disc 2 has (5/14, 1/14). */
  refs_nine_discs(&it, kn, 0.55, 40, 400);
  CU_ASSERT_STRING_EQUAL(refs_refused("nine_discs_statics", &it).text,
                         "this reference is for contacts that do not slip; the contact of particle 1 with wall 1 slips "
                         "at cycle 440 (shear over normal force 0.555556)");
  refs_nine_discs(&it, kn, 0.56, 40, 400);
  solution = refs_solution("nine_discs_statics", &it);
  solution_free(&solution);
  refs_nine_discs(&it, kn, 2, 40, 400);
  strcpy(it.scene.normal, "hertz");
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("nine_discs", &it).text, "hertz"));
}

/* If GSL finds no solution, or if the matrices would be too large, the reference returns an error with a message, and
 * the program continues. */
static void unsolvable_networks_are_refused(void) {
  struct refs_scene it;
  nb_references_prepare();
  for (double ks = 1e200; ks < 1e301; ks *= 1e100) {
    refs_nine_discs(&it, ks, 2, 40, 400);
    CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("nine_discs_statics", &it).text, "cannot be solved"));
    CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("nine_discs_slip", &it).text, "cannot be solved"));
  }
  it.scene.particle_count = 1001; /* the reference refuses so many, and does not read them */
  struct nb_particle *many = calloc(it.scene.particle_count, sizeof *many);
  CU_ASSERT_PTR_NOT_NULL_FATAL(many);
  it.scene.particles = many;
  CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("nine_discs_statics", &it).text, "1000 particles"));
  free(many);
}

/* Two walls move inward, one of them twice as fast as the other, and two walls are at rest. The iteration of the contact
 * states then finds no equilibrium. The message names the increment and the stage. */
static void a_path_without_equilibrium_is_refused(void) {
  struct refs_scene it;
  nb_references_prepare();
  for (size_t stage = 0; stage < 2; stage++) {
    refs_nine_discs(&it, 4 * kn, 0.28, 40, 40);
    for (size_t k = 0; k < 8; k++)
      it.motions[k].vx = k == 4 * stage + 3 ? 0.24 : 0, it.motions[k].vy = k == 4 * stage ? 0.12 : 0;
    const struct nb_error error = refs_refused("nine_discs_distortion", &it);
    CU_ASSERT_PTR_NOT_NULL(strstr(error.text, stage ? "increment 1 of stage 2" : "increment 1 of stage 1"));
  }
}

/* phi is the angle between the contacts and the axis of the zigzag. The reference refuses phi >= 45 degrees. The
 * contacts are then close enough to the direction of the major stress for a chain, but no two of them lie on opposite
 * sides of a disc (zigzag.c). */
static void steep_zigzags_are_refused(void) {
  for (int degrees = 43; degrees <= 55; degrees += 2) {
    const double phi = degrees / 45. * atan(1);
    struct words page = {0};
    struct written it;
    struct refs_scene scene;
    words_add(&page, "units none\nmaterial m density 1 kn 10\nnormal linear\nstep 0.001\nregion A all\n"
                     "wall w -1 -9 to -1 9 m\n");
    for (int k = 0; k < 5; k++)
      words_add(&page, "disc %.17g %.17g radius 1 m%s\n", k % 2 ? 1.99 * sin(phi) : 0, 1.99 * k * cos(phi),
                k % 4 ? "" : " fixed");
    words_add(&page, "record A.chains\nstage s\ncycles 1\n");
    written_scene(&it, &page);
    scene.scene = it.scene;
    if (degrees >= 45) {
      CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused("zigzag", &scene).text, "less than 45 degrees"));
    } else {
      struct nb_solution solution = refs_solution("zigzag", &scene);
      CU_ASSERT_EQUAL(refs_value(&solution, "A.chains"), 0);
      solution_free(&solution);
    }
    written_free(&it);
  }
}

#define PAIR "normal linear\nshear linear\n"
#define BRIEF "step 0.001\nrecord time\nstage s\ncycles 100\n"
#define CELL "step 0.001\nrecord time\nstage s\ncell strain -1e-4 per cycle 0 per cycle\ncycles 10\n"
#define FIELD                                                                                                          \
  "normal hertz\nshear mindlin\nsphere 0 0 radius 1 a\nsphere 8 0 radius 3 a\nregion R circle 0 0 radius 9\n"          \
  "step 0.1 of rayleigh-fit-mean\nrecord R.unbalanced.force\nstage s\naffine strain 1e-6 per cycle -1e-6 per cycle"
/* A disc between two plates with these ends, and a stop that begins at this y. */
#define PLATES(low, high, stop)                                                                                        \
  "normal linear\nshear linear\ndisc 0 1 radius 1 a\nwall low " low " a\nwall high " high " a\n"                       \
  "wall stop 1 " stop " to 1 2.5 smooth\nmonitor L disc 1 with wall low\nstep 0.1\n"                                   \
  "stage press\nwall high velocity 0 -0.001\ncycles 10\n"
#define LOW "-4 0 to 4 0"
#define HIGH "-4 2 to 4 2"
#define COHESIVE PLATES(LOW, HIGH, "0.5")
#define DRAG_AND_PART                                                                                                  \
  "stage drag\nwall low velocity 0.001 0\nwall high velocity 0.001 0\ncycles 10\n"                                     \
  "stage part\nwall low velocity 0 0\nwall high velocity 0 1\ncycles 10\n"
#define SQUEEZE "step 0.05 of single-contact\nstage s\nbox strain 0 per cycle -1e-4 per cycle\ncycles 10\n"

/* Scenes whose features a reference accepts, but whose particles or regions its formulas do not cover. */
static void uncovered_particles_and_regions_are_refused(void) {
  static const char head[] = "units none\nmaterial a density 1 kn 9 ks 9 young 1e6 poisson 0.2 friction 0.5\n"
                             "material b density 1 kn 9 ks 9 young 2e6 poisson 0.2 friction 0.5\n"
                             "material smooth kn 9\n";
  static const struct {
    const char *reference, *page;
    const char *refused, *missing; /* a part of the message, or the name of a value that the solution lacks */
  } scenes[] = {
      {"pinched",
       "normal hertz\nsphere -1.2 0 radius 1 a velocity 0.1 0 fixed\nsphere 1.2 0 radius 1 a velocity -0.1 0 fixed\n"
       "sphere 0 0.5 radius 0.3 b\nstep 1e-6\nstage s\ncycles 1\n",
       "one material", NULL},
      {"cohesion",
       "normal linear\nshear linear\ndisc 0 1 radius 1 a\nwall low -4 0 to 4 0 a\nwall high -4 2 to 4 2 a\n"
       "wall stop 1 0.5 to 1 1.5 b\nmonitor L disc 1 with wall low\nstep 0.1\n"
       "stage press\nwall high velocity 0 -0.001\ncycles 10\n"
       "stage drag\nwall low velocity 0.001 0\nwall high velocity 0.001 0\ncycles 10\n"
       "stage part\nwall low velocity 0 0\nwall high velocity 0 1\ncycles 10\n",
       "neither friction nor cohesion", NULL},
      {"cohesion", COHESIVE DRAG_AND_PART, NULL, "R.normal"},
      {"cohesion", PLATES("-0.0005 0 to 4 0", HIGH, "0.5") DRAG_AND_PART, "press, shear and then leave", NULL},
      {"cohesion", PLATES(LOW, "-0.0005 2 to 4 2", "0.5") DRAG_AND_PART, "press, shear and then leave", NULL},
      {"cohesion", PLATES(LOW, "-4 2 to -0.0005 2", "0.5") DRAG_AND_PART, "press, shear and then leave", NULL},
      {"cohesion", PLATES(LOW, HIGH, "1.5") DRAG_AND_PART, "press, shear and then leave", NULL},
      {"cohesion",
       COHESIVE "stage drag\nwall low velocity 0.001 0\nwall high velocity 0.001 -0.001\ncycles 10\n"
                "stage part\nwall low velocity 0 0\nwall high velocity 0 1\ncycles 10\n",
       "press, shear and then leave", NULL},
      {"cohesion",
       COHESIVE "stage drag\nwall low velocity 0.002 0\nwall high velocity 0.001 0\ncycles 10\n"
                "stage part\nwall low velocity 0 0\nwall high velocity 0 1\ncycles 10\n",
       "press, shear and then leave", NULL},
      {"cohesion",
       COHESIVE "stage drag\nwall low velocity 0 0\nwall high velocity 0 -0.001\ncycles 10\n"
                "stage part\nwall low velocity 0 0\nwall high velocity 0 1\ncycles 10\n",
       "press, shear and then leave", NULL},
      {"cohesion",
       COHESIVE "stage drag\nwall low velocity 0.001 0\nwall high velocity 0.001 0\ncycles 10\n"
                "stage part\nwall low velocity 0 0\nwall high velocity 0 0.001\ncycles 10\n",
       "press, shear and then leave", NULL},
      {"rayleigh_step",
       "normal hertz\nsphere 0 0 radius 1 a velocity 0.1 0\nsphere 2 0 radius 0.9 a\nmonitor D sphere 2\n"
       "step 0.1 of rayleigh\nrecord D.vx\nstage s\ncycles 1\n",
       NULL, "D.vx"},
      {"rayleigh_step",
       "normal hertz\nsphere 0 0 radius 1 a velocity -0.1 0\nsphere 2 0 radius 1 a\nmonitor D sphere 2\n"
       "step 0.1 of rayleigh\nrecord D.vx\nstage s\ncycles 1\n",
       NULL, "D.vx"},
      {"rayleigh_step",
       "normal hertz\nsphere 0 0 radius 1 a velocity 0.1 0\nsphere 2 0.1 radius 1 a\nmonitor D sphere 2\n"
       "step 0.1 of rayleigh\nrecord D.vx\nstage s\ncycles 1\n",
       NULL, "D.vx"},
      {"filling",
       "normal linear\ngrading g 1 5\nfill discs box -9 -9 to 9 9 g a seed 1 attempts 99 else stop\n"
       "region R box -8 -8 to 8 8\nstep 1\nrecord R.porosity\nstage s\ncycles 1\n",
       NULL, "R.porosity"},
      {"centripetal",
       "normal hertz\nsphere 0 0 radius 1 a\nregion R circle 1 0 radius 5\nstep 1\nrecord R.stress.mean\n"
       "stage s\ngravity centripetal 1 about 0 0\ncycles 1\n",
       NULL, "R.stress.mean in s"},
      {"taken_out",
       "normal linear\ndisc 0 0 radius 1 a velocity 0.1 0\ndisc 1.9 0 radius 1 a\nwall w -0.9 -2 to -0.9 2 a\n"
       "monitor D disc 1\nstep 0.01\nrecord D.vx\nstage s\ncycles 1\nstage t\nremove disc 2\ncycles 9999\n",
       NULL, "D.vx"},
      {"force_chain",
       "normal linear\ndisc 0 0 radius 1 a\ndisc 1.7 0 radius 1 a\ndisc 3.8 0 radius 1 a\n"
       "wall w -0.9 -2 to -0.9 2 a\nwall e 4.7 -2 to 4.7 2 a\nregion R box -0.9 -1 to 4.7 1\nstep 0.01\n"
       "stage s\ncycles 1\n",
       "equal discs", NULL},
      {"fracc",
       "normal linear\nmaterial c density 1 kn 5\ndisc 0.001 0 radius 1 a\nwall w -0.9 -5 to -0.9 5 a\n"
       "wall e 0.9 -5 to 0.9 5 c\nwall s -5 -2 to 5 -2 a\nwall n -5 2 to 5 2 a\nstep 0.1 of single-contact\n"
       "stage s\ncycles 1\n",
       "one stiffness", NULL},
      {"speed_of_loading",
       "normal linear\ndamping mass 4\nbox 0 0 to 6 6 a\nlattice discs 3 by 3 radius 1 a\nstep 0.1\nstage s\n"
       "wall west velocity 0.1 0\nwall east velocity 0.1 0\nwall south velocity 0 0.1\nwall north velocity 0 -0.1\n"
       "cycles 9999\n",
       "whose walls approach", NULL},
      {"speed_of_loading",
       "normal linear\ndamping mass 4\nbox 0 0 to 6 6 a\nlattice discs 3 by 1 from 1 1 radius 1 spacing 2 b\n"
       "lattice discs 3 by 2 from 1 3 radius 1 spacing 2 a\nstep 0.1\nstage s\nwalls inward 0.1\ncycles 9999\n",
       "equal discs", NULL},
      {"carried",
       "disc 1 1 radius 1 a\nmonitor D disc 1\nstep 0.1\nrecord D.x\nstage s\n"
       "affine strain 0 per cycle 0 per cycle c12 1e-3 per cycle\ncycles 1\n",
       "along the axes", NULL},
      {"carried",
       "disc 1 1 radius 1 a\nmonitor D disc 1\nstep 0.1\nrecord D.x\nstage s\n"
       "affine strain 0 per cycle 0 per cycle c21 1e-3 per cycle\ncycles 1\n",
       "along the axes", NULL},
      {"wedge",
       "gravity 0 -1\ndisc 0 1.4 radius 1 a\nwall l 0 0 to -4 4 a\nwall r 0 0 to 0.5 0.5 a\nstep 0.1\n"
       "stage s\ncycles 1\n",
       "on the faces of both walls", NULL},
      {"wedge",
       "gravity 0 -1\ndisc 0 1.4 radius 1 a\nwall l 0 0 to -4 4 a\nwall r 4 4 to 0.9 0.9 a\nstep 0.1\n"
       "stage s\ncycles 1\n",
       "on the faces of both walls", NULL},
      {"literal_field",
       "normal hertz\nshear mindlin\nsphere 0 0 radius 1 a\nsphere 3 0 radius 1 b\nregion R circle 0 0 radius 9\n"
       "step 0.1 of rayleigh-fit-mean\nstage s\naffine strain 1e-6 per cycle -1e-6 per cycle accumulated\ncycles 1\n",
       "one material", NULL},
      {"literal_field", FIELD " c12 1e-7 per cycle accumulated\ncycles 1\n", "`affine strain E -E accumulated`", NULL},
      {"literal_field", FIELD " c21 1e-7 per cycle accumulated\ncycles 1\n", "`affine strain E -E accumulated`", NULL},
      {"one_contact",
       PAIR "disc 0 0 radius 1 a\ndisc 1.9 0 radius 1 a\ndisc 9 9 radius 1 a\nmonitor C disc 1 with disc 2\n" BRIEF,
       "two particles, or a particle and a wall", NULL},
      {"one_contact",
       PAIR "disc 0 0 radius 1 a\ndisc 1.9 0 radius 1 a velocity 0 1\nmonitor C disc 1 with disc 2\n" BRIEF,
       "a contact that does not slide", NULL},
      {"one_contact",
       PAIR "disc 0 0.9 radius 1 a velocity 0.05 10\nwall w -5 0 to 5 0 a\nmonitor C disc 1 with wall w\n" BRIEF,
       "opens only with an undeformed shear spring", NULL},
      {"one_contact",
       "normal linear\nshear none\ndisc 0 0.9 radius 1 a velocity 10 0\nwall w -5 0 to 0.5 0 a\n"
       "monitor C disc 1 with wall w\n" BRIEF,
       "a wall so long", NULL},
      {"lattice_moduli",
       PAIR "periodic cell 0 0 to 6 6\nlattice discs 3 by 2 radius 1 a\nlattice discs 3 by 1 from 1 5 radius 1 spacing "
            "2 b\n" CELL,
       "equal particles", NULL},
      {"lattice_moduli", PAIR "periodic cell 0 0 to 9 9\nlattice discs 3 by 3 radius 1 a\n" CELL, "four or six others",
       NULL},
      {"lattice_waves",
       PAIR "periodic cell 0 0 to 5.85 5.85\nlattice discs 3 by 3 radius 1 spacing 1.95 a\nmonitor D disc 1\n" BRIEF,
       "a friction of at least 1e6", NULL},
      {"boxed_lattice",
       "normal linear\nshear none\nbox 0 0 to 4 6 a\nlattice discs 2 by 2 radius 1 a\ndisc 1 5 radius 1 a\n" SQUEEZE,
       "touching discs in a box", NULL},
      {"boxed_lattice",
       "normal linear\nshear none\nbox 0 0 to 4 4 a\nlattice discs 2 by 1 radius 1 a\ndisc 1 3 radius 1 a\n"
       "disc 3 3 radius 1 b\n" SQUEEZE,
       "touching discs in a box", NULL},
      {"boxed_lattice",
       "normal linear\nshear none\nbox 0 0 to 4 4 a\nlattice discs 2 by 1 radius 1 a\ndisc 1 3 radius 1 a\n"
       "disc 3 3.001 radius 1 a\n" SQUEEZE,
       "touching discs in a box", NULL},
      {"boxed_lattice",
       "normal linear\nshear none\nbox 0 0 to 4 4 a\nlattice discs 2 by 2 radius 1 a\nwall w 1 9 to 2 9 a\n" SQUEEZE,
       "touching discs in a box", NULL},
      {"fracc_touch",
       "disc 0 0 radius 1 a velocity 1 0\ndisc 2.1 0.01 radius 1 a\nstep 0.1 of single-contact\nstage s\ncycles 1\n",
       "head-on", NULL},
      {"fracc_touch", "disc 0 0 radius 1 a velocity 1 0\ndisc 2.1 0 radius 1 a\nstep 0.1\nstage s\ncycles 1\n",
       "for `step F of single-contact`", NULL},
  };
  for (size_t k = 0; k < sizeof scenes / sizeof *scenes; k++) {
    struct words page = {0};
    struct written it;
    struct refs_scene scene;
    words_add(&page, "%s%s", head, scenes[k].page);
    written_scene(&it, &page);
    scene.scene = it.scene;
    if (scenes[k].refused) {
      CU_ASSERT_PTR_NOT_NULL(strstr(refs_refused(scenes[k].reference, &scene).text, scenes[k].refused));
    } else {
      struct nb_solution solution = refs_solution(scenes[k].reference, &scene);
      CU_ASSERT_PTR_NULL(solution_find(&solution, scenes[k].missing));
      solution_free(&solution);
    }
    written_free(&it);
  }
}

/* Contact tests whose normal force changes while the contact is sheared, or which prescribe the shear force. The last
 * one does neither. */
static void other_contact_paths_are_refused(void) {
  static const char *const segments[] = {
      "segment press normal to 88 N in 1 step\nsegment rub normal to 90 N slip by 0.1 um in 2 steps\n",
      "segment press normal to 88 N slip by 0.1 um in 1 step\n",
      "segment press normal to 88 N in 1 step\nsegment rub shear to 1 N in 2 steps\n",
      "segment press normal to 88 N in 1 step\nsegment rub slip by 0.1 um in 2 steps\n"};
  for (size_t k = 0; k < sizeof segments / sizeof *segments; k++) {
    struct words page = {0};
    struct written it;
    struct refs_scene scene;
    words_add(&page,
              "path\nmaterial steel young 210 GPa poisson 0.28 friction 0.3\ncontact sphere 10 mm steel with "
              "sphere 10 mm steel\nnormal hertz\nshear mindlin\nrecord step slip shear work.shear\n%s",
              segments[k]);
    written_scene(&it, &page);
    scene.scene = it.scene;
    if (k < 3) {
      CU_ASSERT_STRING_EQUAL(
          refs_refused("contact_ladder", &scene).text,
          "the reference `contact_ladder` is for segments of tangential displacement at one normal force");
    } else {
      struct nb_solution solution = refs_solution("contact_ladder", &scene);
      CU_ASSERT_PTR_NOT_NULL(solution_find_curve(&solution, "shear", "step"));
      solution_free(&solution);
    }
    written_free(&it);
  }
}

/* If all spheres are equal, the Rayleigh step of the mean sphere equals the shortest one, so both give the same velocity
 * after the impact. */
static void rayleigh_steps_of_equal_spheres(void) {
  static const char *const steps[] = {"rayleigh", "rayleigh-mean", "rayleigh-fit", "rayleigh-fit-mean"};
  double vx[4];
  for (int k = 0; k < 4; k++) {
    struct words page = {0};
    struct written it;
    struct refs_scene scene;
    words_add(
        &page,
        "units none\nmaterial a density 1 young 1e6 poisson 0.2\nnormal hertz\nsphere 0 0 radius 1 a velocity 0.1 0\n"
        "sphere 2.001 0 radius 1 a\nmonitor D sphere 2\nstep 0.3 of %s\nrecord D.vx\nstage s\ncycles 1\n",
        steps[k]);
    written_scene(&it, &page);
    scene.scene = it.scene;
    struct nb_solution solution = refs_solution("rayleigh_step", &scene);
    vx[k] = refs_value(&solution, "D.vx");
    solution_free(&solution);
    written_free(&it);
  }
  CU_ASSERT(vx[0] == vx[1] && vx[2] == vx[3] && vx[0] != vx[2] && vx[0] != 0.1);
}

/* Spheres of the radii 1 and 3 have the mean radius 2 and the mean mass (4/3) pi 14 of the density 1. The mean sum of
 * forces is that of the reference's comment, with the strain 1e-6 per cycle in a circle of the radius 9. */
static void means_of_an_assembly_with_two_sizes(void) {
  const double pi = 3.14159265358979323846, shear = 1e6 / (2 * (1 + 0.2)), mass = 4 * pi / 3 * 14;
  const double step = 0.1 * pi * 2 * sqrt(1 / shear) / (0.1631 * 0.2 + 0.876605);
  struct words page = {0};
  struct written it;
  struct refs_scene scene;
  words_add(&page,
            "units none\nmaterial a density 1 young 1e6 poisson 0.2 friction 0.5\n" FIELD " accumulated\ncycles 1\n");
  written_scene(&it, &page);
  scene.scene = it.scene;
  struct nb_solution solution = refs_solution("literal_field", &scene);
  const double expected = mass * 2 / 3 * 9 * 1e-6 / (step * step);
  REFS_NEAR(refs_value(&solution, "R.unbalanced.force in s"), expected, 1e-14, expected);
  solution_free(&solution);
  written_free(&it);
}

/* The greatest kinetic energy is the first one, unless a wall or a fixed particle moves and may add energy. */
static void rebound_without_energy_from_outside(void) {
  static const struct {
    const char *other; /* what sphere 1, at the origin, meets in the direction of -y */
    bool keeps;
  } cases[] = {
      {"wall w -9 -1 to 9 -1 a\nmonitor C sphere 1 with wall w", true},
      {"wall w -9 -1 to 9 -1 a velocity 0 0.1\nmonitor C sphere 1 with wall w", false},
      {"sphere 0 -2 radius 1 a\nmonitor C sphere 1 with sphere 2", true},
      {"sphere 0 -2 radius 1 a velocity 0 0.1\nmonitor C sphere 1 with sphere 2", true},
      {"sphere 0 -2 radius 1 a fixed\nmonitor C sphere 1 with sphere 2", true},
      {"sphere 0 -2 radius 1 a velocity 0 0.1 fixed\nmonitor C sphere 1 with sphere 2", false},
      {"sphere 0 -2 radius 1 a spin 0.1 fixed\nmonitor C sphere 1 with sphere 2", false},
  };
  for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
    struct words page = {0};
    struct written it;
    struct refs_scene scene;
    words_add(&page,
              "units none\nmaterial a density 1 young 1e6 poisson 0.2 friction 0.1\nnormal hertz\n"
              "shear mindlin_deresiewicz\nsphere 0 0 radius 1 a\n%s\nimpact C speed 0.5 angle 0.5\nstep 0.001\n"
              "record energy.kinetic\nstage s\ncycles 1\n",
              cases[k].other);
    written_scene(&it, &page);
    scene.scene = it.scene;
    struct nb_solution solution = refs_solution("rebound", &scene);
    CU_ASSERT(refs_value(&solution, "energy.kinetic") > 0);
    CU_ASSERT_EQUAL(solution_find(&solution, "energy.kinetic max") != NULL, cases[k].keeps);
    solution_free(&solution);
    written_free(&it);
  }
}

/* A disc that rolls down a plane; m = k_n = pi, so the single-contact step 2 (m/k_n)^(1/2) is 2 s, and ten steps of half
 * of it take 10 s. The acceleration is 2/3 of the gravity along the plane. */
static void a_step_relative_to_a_single_contact(void) {
  struct words page = {0};
  struct written it;
  struct refs_scene scene;
  words_add(&page, "units none\nmaterial a density 1 kn 3.14159265358979323846 ks 1 friction 1\nnormal linear\n"
                   "shear linear\ngravity 0.3 -1\ndisc 0 1 radius 1 a\nwall w -9 0 to 9 0 a\nmonitor D disc 1\n"
                   "step 0.5 of single-contact\nrecord D.vx\nstage s\ncycles 10\n");
  written_scene(&it, &page);
  scene.scene = it.scene;
  struct nb_solution solution = refs_solution("incline", &scene);
  REFS_NEAR(refs_value(&solution, "D.vx in s"), 2, 1e-14, 2.);
  solution_free(&solution);
  written_free(&it);
}

/* A disc on a plane with mu = 0.25, so that it slides where p > 3 mu n = 0.75 n, with the gravity p along the plane and n
 * into it. With n = 4 the edge is p = 3. */
static void planes_on_which_a_disc_rolls_again_are_refused(void) {
  static const struct {
    const char *stages; /* after a first stage with p = 1 */
    bool covered;
  } rows[] = {
      {"stage s\ngravity 3.01 -4\ncycles 9\nstage t\ngravity 3.02 -4\ncycles 9\n", true},
      {"stage s\ngravity 3.01 -4\ncycles 9\nstage t\ngravity 2.99 -4\ncycles 9\n", false},
      {"stage s\nramp gravity 3.01 -4\ncycles 9\nstage t\nramp gravity 3.02 -4\ncycles 9\n", true},
      {"stage s\nramp gravity 3.01 -4\ncycles 9\nstage t\nramp gravity 2.99 -4\ncycles 9\n", false},
      {"stage s\nramp gravity 3.01 -4\ncycles 9\nstage t\nramp gravity 3.01 -4.02\ncycles 9\n", false},
      {"stage s\nramp gravity 2.99 -4\ncycles 9\nstage t\nramp gravity 1 -4\ncycles 9\n", true},
      {"stage s\ngravity 3.01 -4\ncycles 9\nstage t\nramp gravity 2.99 -4\ncycles 9\n", false},
      {"stage s\ngravity -2.99 -4\ncycles 9\n", true},
      {"stage s\ngravity -3.01 -4\ncycles 9\n", false},
      {"stage s\nramp gravity -2.99 -4\ncycles 9\n", true},
      {"stage s\nramp gravity -3.01 -4\ncycles 9\n", false},
      {"stage s\ngravity -3.01 -4\ncycles 9\nstage t\nramp gravity 1 -4\ncycles 9\n", false},
  };
  const size_t tried = sizeof rows / sizeof *rows;
  for (size_t k = 0; k < tried + 2; k++) { /* the last two: 32 and 33 stages */
    struct words page = {0};
    struct written it;
    struct refs_scene scene;
    words_add(&page, "units none\nmaterial a density 1 kn 1e4 ks 1e4 friction 0.25\nnormal linear\nshear linear\n"
                     "gravity 1 -4\ndisc 0 1 radius 1 a\nwall w -9 0 to 9 0 a\nmonitor D disc 1\nstep 0.001\n"
                     "record D.vx\nstage first\ncycles 9\n");
    for (size_t s = 0; k >= tried && s < 31 + k - tried; s++)
      words_add(&page, "stage s%zu\ncycles 9\n", s);
    words_add(&page, "%s", k < tried ? rows[k].stages : "");
    written_scene(&it, &page);
    scene.scene = it.scene;
    if (k < tried ? rows[k].covered : k == tried) {
      struct nb_solution solution = refs_solution("incline", &scene);
      solution_free(&solution);
    } else {
      CU_ASSERT_STRING_EQUAL(
          refs_refused("incline", &scene).text,
          "the reference `incline` is for up to 32 stages, and a particle that slides only in +x and "
          "does not roll again");
    }
    written_free(&it);
  }
}

/* A grading of three discs and two smaller ones: a monitor of one size counts that size only. */
static void a_filling_counts_each_size(void) {
  struct words page = {0};
  struct written it;
  struct refs_scene scene;
  words_add(&page, "units none\nmaterial a density 1 kn 9\nnormal linear\ngrading g 1 3 0.5 2\n"
                   "fill discs box -9 -9 to 9 9 g a seed 1 attempts 99 else stop\nmonitor G grading g\n"
                   "monitor L grading g radius 1\nmonitor S grading g radius 0.5\nstep 1\nrecord G.placed\nstage s\n"
                   "cycles 1\n");
  written_scene(&it, &page);
  scene.scene = it.scene;
  struct nb_solution solution = refs_solution("filling", &scene);
  CU_ASSERT_EQUAL(refs_value(&solution, "G.placed"), 5);
  CU_ASSERT_EQUAL(refs_value(&solution, "L.placed"), 3);
  CU_ASSERT_EQUAL(refs_value(&solution, "S.placed"), 2);
  CU_ASSERT_EQUAL(refs_value(&solution, "S.wanted"), 2);
  solution_free(&solution);
  written_free(&it);
}

/* Ends a child before LeakSanitizer searches for leaks, which would change the exit status. */
static void leave(int status, void *unused) {
  (void)unused;
  _exit(status);
}

/* References do not check whether GSL could allocate memory, because the error handler of GSL ends the program. */
static void failed_allocation_in_gsl_ends_the_program(void) {
  int status = -1;
  nb_references_prepare();
  fflush(NULL);
  const pid_t child = fork();
  if (child == 0) {
    fclose(stderr);
    on_exit(leave, NULL);
    gsl_error("failed to allocate space", __FILE__, __LINE__, GSL_ENOMEM);
    _exit(0);
  }
  CU_ASSERT(child > 0 && waitpid(child, &status, 0) == child);
  CU_ASSERT(WIFEXITED(status) && WEXITSTATUS(status) == NB_NO_MEMORY);
}

static double twice(const void *data, double x) { return 2 * x + *(const double *)data; }

static void solution_keeps_values_and_curves(void) {
  struct nb_solution solution = {0};
  struct nb_error error = {0};
  char name[16];
  for (int i = 0; i < 100; i++) {
    snprintf(name, sizeof name, "C.%d", i);
    solution_value(&solution, i, name);
  }
  double *data = malloc(sizeof *data);
  CU_ASSERT_PTR_NOT_NULL_FATAL(data);
  *data = 1;
  solution_curve(&solution, "C.normal", "time", twice, data);
  for (int i = 0; i < 100; i++) {
    snprintf(name, sizeof name, "C.%d", i);
    CU_ASSERT_EQUAL(refs_value(&solution, name), i);
  }
  CU_ASSERT_PTR_NULL(solution_find(&solution, "C.100"));
  const struct nb_solution_curve *curve = solution_find_curve(&solution, "C.normal", "time");
  CU_ASSERT_PTR_NOT_NULL_FATAL(curve);
  CU_ASSERT_EQUAL(curve->at(curve->data, 3), 7);
  CU_ASSERT_PTR_NULL(solution_find_curve(&solution, "C.normal", "cycle"));
  CU_ASSERT_EQUAL(solution_status(&solution, &error), NB_OK);
  solution_curve(&solution, "C.shear", "time", twice, NULL); /* a curve whose data could not be allocated */
  CU_ASSERT_EQUAL(solution_status(&solution, &error), NB_NO_MEMORY);
  solution_free(&solution);
  CU_ASSERT_EQUAL(solution.value_count, 0);
  for (const struct nb_reference *const *it = nb_references(); *it; it++)
    CU_ASSERT_PTR_EQUAL(nb_reference_find((*it)->name), *it);
  CU_ASSERT_PTR_NULL(nb_reference_find("nine_disks"));
}

/* The masses and constants that references use, compared with values computed by hand, and with those of the
 * simulator. */
static void masses_and_contact_constants(void) {
  struct nb_material materials[3] = {
      {.density = 3, .kn = 6, .ks = 2, .friction = 0.5, .cohesion = 7, .young = 182, .poisson = 0.3},
      {.density = 5, .kn = 3, .ks = 2, .friction = 0.25, .cohesion = 9, .young = 75, .poisson = 0.25},
      {.young = INFINITY}};
  struct nb_pair_rule rules[2] = {{.a = 1, .b = 0, .kn = NAN, .ks = 11, .friction = 0, .cohesion = NAN},
                                  {.a = 0, .b = 0, .kn = 13, .ks = NAN, .friction = NAN, .cohesion = 21}};
  const struct nb_particle disc = {.shape = NB_DISC, .radius = 2},
                           sphere = {.shape = NB_SPHERE, .radius = 3, .material = 1};
  struct nb_scene scene = {.materials = materials, .material_count = 3};
  CU_ASSERT_DOUBLE_EQUAL(matter_mass(&scene, &disc), 37.69911184307752, 1e-13);    /* 12 pi */
  CU_ASSERT_DOUBLE_EQUAL(matter_inertia(&scene, &disc), 75.39822368615503, 1e-13); /* 24 pi */
  CU_ASSERT_DOUBLE_EQUAL(matter_mass(&scene, &sphere), 565.4866776461628, 1e-12);  /* 180 pi */
  CU_ASSERT_DOUBLE_EQUAL(matter_inertia(&scene, &sphere), 2035.7520395261859, 1e-11);
  CU_ASSERT_DOUBLE_EQUAL(matter_radius(2, 3), 1.2, 1e-15);
  CU_ASSERT_EQUAL(matter_radius(2, INFINITY), 2);
  struct matter_pair pair = matter_pair(&scene, 0, 1);
  CU_ASSERT_DOUBLE_EQUAL(pair.kn, 4, 1e-15);
  CU_ASSERT_DOUBLE_EQUAL(pair.ks, 2, 1e-15);
  CU_ASSERT(pair.friction == 0.25 && pair.cohesion == 7);
  CU_ASSERT_DOUBLE_EQUAL(pair.young, 1 / (0.005 + 0.0125), 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(pair.shear, 1 / (1.7 / 70 + 1.75 / 30), 1e-12);
  CU_ASSERT_DOUBLE_EQUAL(matter_pair(&scene, 0, 2).young, 200, 1e-12); /* one is rigid */
  scene.pair_rules = rules, scene.pair_rule_count = 2;
  pair = matter_pair(&scene, 0, 1);
  CU_ASSERT_DOUBLE_EQUAL(pair.kn, 4, 1e-15);
  CU_ASSERT(pair.ks == 11 && pair.friction == 0 && pair.cohesion == 7);
  const struct matter_pair same = matter_pair(&scene, 0, 0);
  CU_ASSERT(same.kn == 13 && same.friction == 0.5 && same.cohesion == 21);
  CU_ASSERT_DOUBLE_EQUAL(same.ks, 2, 1e-15);
  const struct nb_pair simulated = nb_scene_pair(&scene, 0, 1);
  REFS_NEAR(simulated.kn, pair.kn, 1e-15, 4.);
  REFS_NEAR(simulated.young, pair.young, 1e-15, 60.);
  REFS_NEAR(simulated.shear, pair.shear, 1e-15, 12.);
  REFS_NEAR(nb_particle_mass(&scene, &disc), matter_mass(&scene, &disc), 1e-15, 40.);
  REFS_NEAR(nb_particle_inertia(&scene, &sphere), matter_inertia(&scene, &sphere), 1e-15, 2000.);
}

/* A particle of material 0 and a wall. The rule for one pair of materials has friction and cohesion. The scene has these
 * features only if the pair is that of the particle and the wall. */
static void friction_and_cohesion_at_a_wall(void) {
  struct refs_scene it;
  memset(&it, 0, sizeof it);
  strcpy(it.scene.normal, "linear"), strcpy(it.scene.shear, "linear");
  it.scene.materials = it.materials, it.scene.material_count = 2;
  it.scene.pair_rules = it.rules, it.scene.pair_rule_count = 1;
  it.scene.particles = it.particles, it.scene.particle_count = 1;
  it.scene.walls = it.walls, it.scene.wall_count = 1;
  it.materials[0].line = 12, it.materials[1].line = 13, it.walls[0].material = 1;
  for (int b = 0; b < 2; b++)              /* the rule is for the materials 1 and 0, or for material 1 with itself */
    for (int wall = 0; wall < 2; wall++) { /* the wall has the material of the particle, or the other one */
      int lines[NB_FEATURES];
      it.rules[0] = (struct nb_pair_rule){.a = 1, .b = b, .kn = NAN, .ks = NAN, .friction = 0.5, .cohesion = 1};
      it.walls[0].material = wall;
      nb_features(lines, &it.scene);
      CU_ASSERT_EQUAL(lines[HAS_FRICTION], wall == 1 && b == 0 ? 12 : -1);
      CU_ASSERT_EQUAL(lines[HAS_COHESION], wall == 1 && b == 0 ? 12 : -1);
    }
}

/* A solution lacks values when memory runs out. Then no reference may report success. The scene of a reference is the
 * first page that uses it. */
static void every_reference_reports_missing_memory(void) {
  static const char *const pages[] = {
#define NB_PAGE(path) path,
#include "pages-register.h"
#undef NB_PAGE
  };
  const struct nb_reference *tested[256];
  size_t count = 0;
  for (size_t p = 0; p < sizeof pages / sizeof *pages; p++) {
    struct nb_outcome outcome;
    struct nb_error error;
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", NB_SRCDIR, pages[p]);
    CU_ASSERT_EQUAL_FATAL(nb_outcome_read(&outcome, path, NULL), NB_OK);
    const struct nb_reference *const reference = outcome.runs[0].expectations.reference;
    size_t k = 0;
    while (k < count && tested[k] != reference)
      k++;
    if (reference && k == count) {
      struct nb_solution solution = {.incomplete = true};
      const enum nb_status status = nb_reference_solve(reference, &solution, &outcome.runs[0].scene, &error);
      if (status != NB_NO_MEMORY)
        printf("# %s: status %d\n", reference->name, status);
      CU_ASSERT_EQUAL(status, NB_NO_MEMORY);
      solution_free(&solution);
      tested[count++] = reference;
    }
    nb_outcome_free(&outcome);
  }
  CU_ASSERT(count > 50);
}

void suite_refs(void) {
  CU_pSuite suite = CU_add_suite("refs", NULL, NULL);
  CU_add_test(suite, "masses and constants of contacts", masses_and_contact_constants);
  CU_add_test(suite, "a solution keeps its values and curves", solution_keeps_values_and_curves);
  CU_add_test(suite, "scenes outside the theory are refused", scenes_outside_the_theory_are_refused);
  CU_add_test(suite, "networks that cannot be solved are refused", unsolvable_networks_are_refused);
  CU_ADD_TEST(suite, a_path_without_equilibrium_is_refused);
  CU_add_test(suite, "zigzags of 45 degrees and more are refused", steep_zigzags_are_refused);
  CU_add_test(suite, "particles and regions that a formula does not cover are refused",
              uncovered_particles_and_regions_are_refused);
  CU_ADD_TEST(suite, other_contact_paths_are_refused);
  CU_add_test(suite, "failed allocation in GSL ends the program", failed_allocation_in_gsl_ends_the_program);
  CU_ADD_TEST(suite, every_reference_reports_missing_memory);
  CU_add_test(suite, "friction and cohesion of a particle and a wall", friction_and_cohesion_at_a_wall);
  CU_ADD_TEST(suite, rayleigh_steps_of_equal_spheres);
  CU_ADD_TEST(suite, means_of_an_assembly_with_two_sizes);
  CU_ADD_TEST(suite, rebound_without_energy_from_outside);
  CU_ADD_TEST(suite, a_step_relative_to_a_single_contact);
  CU_ADD_TEST(suite, planes_on_which_a_disc_rolls_again_are_refused);
  CU_ADD_TEST(suite, a_filling_counts_each_size);
}
