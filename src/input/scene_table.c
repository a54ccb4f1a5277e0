/* The statements of scene blocks, one row each: the words, what they take (scene_fields.h), and a line for the manual.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "scene_fields.h"

/* clang-format off */

static const struct nb_keyword table[] = {
  {"units", NB_IN_SCENE | NB_IN_PATH, units, NULL, 0, false, nb_apply_units,
   "Whether numbers carry units: `si`, the default, or `none`, with which all numbers are bare. It holds for the "
   "whole page.",
   "units     si"},
  {"let", NB_IN_SCENE | NB_IN_PATH | NB_IN_START, name_of_value, "VALUE", 0, true, nb_apply_let,
   "Gives a name to a value, a word or a number and its unit. $NAME stands for it below; --set NAME=VALUE "
   "overrides it.",
   "let       grip 0.3"},
  {"sweep", NB_IN_SCENE | NB_IN_PATH | NB_IN_START, name_of_value, "{with NAME …} VALUE …", 0, true, nb_apply_sweep,
   "Gives a name several values in turn, one run each; several names take their values together, and giving one of them a value by --set chooses what goes with it. Several sweeps make "
   "the product, the last one fastest.",
   "sweep     speed 0.1 m/s 0.2 m/s"},
  {"start", NB_IN_SCENE | NB_APART, start, "{with NAME=VALUE …}", 0, false, nb_apply_start,
   "Goes on where a stage of another page ends: PAGE.md, given these values as by --set. The page is found by its name: beside this one; else in the nearest "
   "folder `cases` that this page lies in, or in any folder below, where the name must be there once. A name with `../` or `/` at its beginning is a path from this page's folder or from the root. Bodies, walls, a boundary or a cell, materials, "
   "laws, damping, gravity and step are those of its end, cycles and time count on; watches and columns are this page's own. What "
   "is said before the first stage holds from that stage on. The other page is run up to there once, and its state kept in a "
   "folder: docs/STATE.md. Stands before all but `units`, `let` and `sweep`.",
   "start     nine-discs stage load\nwatch     C  disc 5 with disc 6\nrecord    cycle C.normal\nstage     rest\n  walls   stop\n  cycles  400"},
  {"material", NB_IN_SCENE | NB_IN_PATH, material, NULL, 0, true, nb_apply_material,
   "What bodies and walls are made of: the stiffness, friction and cohesion of a contact between two of the same "
   "material.",
   "material  steel  density 7.8 g/cm3  kn 10 MN/m  ks 8 MN/m  friction $grip\nmaterial  glass  density 2.5 g/cm3  kn 5 MN/m   ks 4 MN/m  friction 0.2"},
  {"pair", NB_IN_SCENE | NB_IN_PATH, pair, NULL, 0, false, nb_apply_pair,
   "What holds between two materials where the rule does not: harmonic mean of stiffnesses, smaller friction and "
   "cohesion.",
   "pair      steel glass  friction 0.1"},
  {"normal", NB_IN_SCENE | NB_IN_PATH | NB_IN_STAGE | NB_IN_START, law, NULL, 0, false, nb_apply_law,
   "The law of the normal force; `nineball laws` lists them; default linear. --set normal=LAW overrides it everywhere. In a stage: from "
   "this stage on; another law begins with contacts of which it remembers nothing.",
   "normal    linear"},
  {"shear", NB_IN_SCENE | NB_IN_PATH | NB_IN_STAGE | NB_IN_START, shear_law, NULL, 1, false, nb_apply_law,
   "The law of the shear force; `nineball laws` lists them; default none. --set shear=LAW overrides it everywhere. In a stage: from this "
   "stage on, as `normal`.",
   "shear     linear"},
  {"damping", NB_IN_SCENE | NB_IN_STAGE | NB_IN_START, nothing,
   "{walls} contact-beta TIME|contact-fraction X|contact-ratio X | walls none | critical above SHARE | global RATE | "
   "con1 X reading cs79|velocity|all | none",
   0, false, nb_apply_damping,
   "Damping at contacts [CS79 28] [R89 4.3, 4.13] and of all bodies [CS79 34] [R89 6.5.1], one statement for each; "
   "default none. `walls` is for contacts with walls alone, which are damped as all others without it. `critical above`: contacts "
   "that overlap by more than that share of the smaller diameter are damped critically [R89 6.4.3]. In a stage: from this "
   "stage on.",
   "damping   contact-ratio 0.1\ndamping   walls contact-ratio 0.3\ndamping   global 2 1/s"},
  {"gravity", NB_IN_SCENE | NB_IN_STAGE | NB_IN_RAMP | NB_IN_START, gravity, NULL, 0, false, nb_apply_gravity,
   "The same acceleration on all bodies that are free; default none. In a stage: from this stage on.",
   "gravity   0 m/s2 -9.81 m/s2"},
  {"disc", NB_IN_SCENE, body, NULL, NB_DISC, true, nb_apply_body,
   "One disc, a cylinder 1 m thick; it gets the next number.",
   "disc      35.02 mm 60 mm  radius 5 mm  steel  velocity -$speed 0 m/s  spin -3 rad/s"},
  {"sphere", NB_IN_SCENE, body, NULL, NB_SPHERE, true, nb_apply_body,
   "One sphere, which moves in the plane; it gets the next number.",
   "sphere    25 mm 60 mm  radius 5 mm  glass"},
  {"discs lattice", NB_IN_SCENE, lattice, NULL, NB_DISC, true, nb_apply_lattice,
   "Discs in a lattice, numbered row by row from the south-west: to the east, then the next row to the north.",
   "discs     lattice 3 by 2  from 15 mm 15 mm  radius 5 mm  spacing 12 mm  glass"},
  {"spheres lattice", NB_IN_SCENE, lattice, NULL, NB_SPHERE, true, nb_apply_lattice,
   "Spheres in a lattice, numbered as `discs lattice`.",
   "spheres   lattice hexagonal 2 by 1  from 15 mm 40 mm  radius 5 mm  steel"},
  {"grading", NB_IN_SCENE, grading, "RADIUS N {RADIUS N …}", 0, true, nb_apply_grading,
   "How many bodies of which radius: what `fill` fills with.",
   "grading   mixed  8 mm 2  5 mm 6"},
  {"spheres fill circle", NB_IN_SCENE, fill_circle, NULL, NB_SPHERE, true, nb_apply_fill,
   "Spheres of a grading at random in a circle, largest first and numbered so, wholly inside and not touching each other nor a body "
   "that is there already (R89, sections 4.4 and 6.4); walls are not looked at. What is meant by a seed is the same on every machine. For a body that finds no place in so many tries: "
   "`else stop` says so and ends, as the old generator did, `else skip` goes on with the next smaller size; then what was dropped is a quantity.",
   "spheres   fill circle 200 mm 40 mm radius 30 mm  mixed steel  seed 1  tries 1000  else skip"},
  {"spheres fill box", NB_IN_SCENE, fill_box, NULL, NB_SPHERE, true, nb_apply_fill,
   "The same in a box, whose sides are no walls.",
   "spheres   fill box 250 mm 0 mm to 320 mm 80 mm  mixed steel  seed 2  tries 1000  else stop"},
  {"discs fill circle", NB_IN_SCENE, fill_circle, NULL, NB_DISC, true, nb_apply_fill,
   "The same with discs.",
   "discs     fill circle 200 mm 140 mm radius 30 mm  mixed glass  seed 3  tries 1000  else skip"},
  {"discs fill box", NB_IN_SCENE, fill_box, NULL, NB_DISC, true, nb_apply_fill,
   "Discs in a box.",
   "discs     fill box 250 mm 100 mm to 320 mm 180 mm  mixed glass  seed 4  tries 1000  else stop"},
  {"packing", NB_IN_SCENE | NB_APART, packing, NULL, -1, true, nb_apply_packing,
   "Bodies from a file that `nineball state` has written, in its order: discs and spheres, with their radii where they were, free or fixed, of the page's "
   "materials of the same names. They are at rest, and the contacts between them remember nothing. Numbers come as they are in the file, to the last bit: docs/STATE.md. The file is "
   "found as a page is by `start`.",
   "material  rock  density 2000 kg/m3  kn 1 MN/m\npacking   heap.state"},
  {"discs packing", NB_IN_SCENE | NB_APART, packing_of, NULL, NB_DISC, true, nb_apply_packing,
   "Discs of one material where bodies are in a file: one as for `packing`, or a list under a head line with columns `x/m`, `y/m` and `radius/m`, in any unit of length, "
   "parted by tabs or by blanks; other columns are passed over, and lines that begin with `#`. So STAGE-bodies.tsv of any run will do.",
   "material  rock  density 2000 kg/m3  kn 1 MN/m\ndiscs     packing heap.tsv rock"},
  {"spheres packing", NB_IN_SCENE | NB_APART, packing_of, NULL, NB_SPHERE, true, nb_apply_packing,
   "The same with spheres.",
   "material  rock  density 2000 kg/m3  kn 1 MN/m\nspheres   packing heap.tsv rock"},
  {"box", NB_IN_SCENE, box, NULL, 0, true, nb_apply_box, "Four walls named south, east, north and west.",
   "box       0 mm 0 mm to 80 mm 80 mm  steel"},
  {"wall", NB_IN_SCENE, wall, NULL, 0, true, nb_apply_wall,
   "A straight wall between two ends; it pushes on both sides.",
   "wall      shelf  10 mm 48 mm to 60 mm 48 mm  glass"},
  {"cell", NB_IN_SCENE | NB_IN_CELL, cell, NULL, 0, false, nb_apply_cell,
   "A periodic cell: copies of it fill the plane, and every body of it meets those of others. All bodies belong to it, wherever "
   "they are. In place of walls; then there are quantities `cell.NAME`.",
   "cell      0 mm 0 mm to 80 mm 80 mm"},
  {"wave", NB_IN_SCENE | NB_IN_CELL, wave, "periods NX NY", 0, false, nb_apply_wave,
   "Gives the free bodies above a velocity more, times the sine of a plane wave: so many periods from side to side of the "
   "cell, to the east and to the north, from its centre.",
   "wave      0 m/s 1 mm/s  periods 1 0"},
  {"skin", NB_IN_SCENE | NB_IN_START, skin, NULL, 0, false, nb_apply_skin,
   "Pairs closer than this are listed as contacts that may come to touch [R89 TOL], and looked for again when something "
   "has moved half of it; default a tenth of the mean radius. No result depends on it.",
   "skin      0.5 mm"},
  {"watch", NB_IN_SCENE | NB_IN_START, watch,
   "disc N | disc N with disc M | disc N with wall NAME | wall NAME | grading NAME {radius R}", 0, true, nb_apply_watch,
   "Names a body, a contact, a wall, or a grading or one size of it, so that its quantities can be asked for: `C.normal`. Spheres are `sphere N`.",
   "watch     A  disc 1\nwatch     C  disc 1 with sphere 2\nwatch     F  sphere 9 with wall shelf\nwatch     S  wall shelf\nwatch     G  grading mixed\nwatch     H  grading mixed radius 5 mm"},
  {"region", NB_IN_SCENE | NB_IN_START, region, "circle X Y radius R {rings N} | box X1 Y1 to X2 Y2 | inside F {rings N} | all {from STAGE}", 0, true, nb_apply_region,
   "Names a part of the plane, so that what is in it can be measured as a whole: `A.stress.mean`. A body is inside when its centre is; `inside` is a circle about the boundary's centre, F of its mean radius; `all` is the smallest box round all outlines that is upright before `place`, or the cell. With `rings` a snapshot holds the porosity of as many rings of equal width about its centre; strain, and what contacts are lost and new, are counted from the stage of this page that `from` names, else from the start of its run.",
   "region    M  circle 40 mm 40 mm radius 30 mm  rings 6"},
  {"impact", NB_IN_SCENE, impact, NULL, 0, false, nb_apply_impact,
   "Lets the first body of a watched contact strike the other one, or the wall: from the side where the page has put it, "
   "it is moved until it just touches and flies from there, east when what it strikes lies to the south. Its velocity is replaced, its spin is "
   "not. Then there are quantities `impact.NAME`.",
   "impact    F  speed 0.4 m/s  angle 20 deg  phase 0.5"},
  {"place", NB_IN_SCENE, place, NULL, 0, false, nb_apply_place,
   "Moves the whole scene, as it is at the end of the page: positions, velocities, walls and what they do in stages. "
   "First it is mirrored, then turned about the origin, then shifted. All that the page says with a direction turns with it, "
   "the components that a `servo` holds too. The physics stays the same; quantities with a direction, recorded or waited for by `until`, "
   "do not: they are those of the plane.",
   "place     mirror none  turn 0 deg  shift 0.5 m 0 m"},
  {"step", NB_IN_SCENE | NB_IN_STAGE | NB_IN_START, nothing, "TIME | N per contact | F of contact|safe|critical|rayleigh|rayleigh-mean|rayleigh-fit|rayleigh-fit-mean", 0, false, nb_apply_step,
   "How long a cycle is: a time, or a share of what is sure to be stable as a stage begins, of 2 sqrt(m/k) [CS79, "
   "Motion], or of the duration of the shortest contact there can be; no default. `N per contact` is the N-th part of that. "
   "Elastic spheres meet for Hertz's time, which goes with their speed: of those that would meet if all went straight on "
   "from there. `rayleigh` is a surface wave's time half round the smallest sphere, `rayleigh-mean` round the mean one, "
   "with `-fit` by R89's fit of its speed [R89 4.33, 4.34]. In a stage: from this stage on. --set step=... overrides it everywhere.",
   "step      0.1 of critical"},
  {"allow", NB_IN_SCENE | NB_IN_STAGE | NB_IN_START, nothing, "unstable", 0, false, nb_apply_allow,
   "Lets a run go on whose step is above what is sure to be stable; else it stops there. In a stage: in this one only.",
   "allow     unstable"},
  {"record", NB_IN_SCENE | NB_IN_PATH | NB_IN_START, nothing, "QUANTITY …", 0, false, nb_apply_columns,
   "The columns of the table, in this order; on the bench default step, overlap, slip, normal and shear.",
   "record    time A.x A.vx C.overlap C.normal S.fy energy.kinetic"},
  {"stage", NB_IN_SCENE | NB_IN_STAGE | NB_IN_START, stage, NULL, 0, true, nb_apply_stage,
   "Begins a stage; the statements below belong to it, until the next one.",
   "stage     strike"},
  {"walls", NB_IN_STAGE | NB_IN_RAMP, walls, NULL, 0, false, nb_apply_walls,
   "How all walls move from the beginning of this stage on: one of the two.",
   "  walls   inward 1 mm/s"},
  {"wall", NB_IN_STAGE | NB_IN_RAMP, wall_motion, NULL, 0, false, nb_apply_wall_motion,
   "How one wall moves from the beginning of this stage on: the velocity of its point P, its spin about P, or both.",
   "  wall    shelf  velocity 0 m/s -2 mm/s  spin 0.1 rad/s"},
  {"material", NB_IN_STAGE | NB_IN_RAMP | NB_IN_START, material_change, NULL, 0, false, nb_apply_change,
   "What a material is from this stage on; what is not said stays as it was.",
   "  material glass  friction 0.4"},
  {"pair", NB_IN_STAGE | NB_IN_RAMP | NB_IN_START, pair_change, NULL, 1, false, nb_apply_change,
   "What holds between two materials from this stage on, whatever the rule says; what is not said stays as it was.",
   "  pair    steel glass  cohesion 1 N"},
  {"cell strain", NB_IN_STAGE | NB_IN_CELL, strain, NULL, 0, false, nb_apply_cell_strain,
   "How the periodic cell is strained from the beginning of this stage on, about its centre, and all bodies in it are carried along "
   "[R89 4.43, 4.44].",
   "  cell    strain -0.01 1/s -0.01 1/s"},
  {"ramp", NB_IN_STAGE, nothing, "wall … | walls … | material … | pair … | gravity … | servo …", 0, false, nb_apply_ramp,
   "What follows does not jump but goes along a straight line, from what it is to what is said, over the cycles of the "
   "stage.",
   "  ramp    material steel  friction 0.5"},
  {"cycles", NB_IN_STAGE, cycles, NULL, 0, true, nb_apply_cycles, "How many cycles the stage lasts.",
   "  cycles  400"},
  {"until", NB_IN_STAGE, nothing,
   "QUANTITY above|below VALUE {and QUANTITY above|below VALUE …} {every N cycles} at most N cycles", 0, true, nb_apply_until,
   "The stage lasts until all conditions hold; that they do not hold after N cycles is a failure. `every`: they are looked at every so many cycles only, default 1.",
   "stage     part\n  until   C.overlap below 1 nm and time above 1 ms  at most 10000 cycles"},
  {"record", NB_IN_STAGE | NB_IN_LEG, nothing, "every N cycles | none", 0, false, nb_apply_record,
   "How often a row is added to the table; default every 1 cycle.",
   "  record  every 10 cycles"},
  {"snapshot", NB_IN_STAGE | NB_IN_LEG, nothing, "{from STAGE}", 0, false, nb_apply_snapshot,
   "Keeps bodies, walls and contacts as they are at the end of the stage; on the bench the traction over the contact and "
   "the pieces of its history, which a shear law must keep. With `from` also what has changed since that stage began, which is this one or "
   "an earlier one: how bodies have moved and turned, which contacts are new and which are lost, how far contacts have slid.",
   "  snapshot from strike"},
  {"still", NB_IN_STAGE, nothing, NULL, 0, false, nb_apply_still,
   "All bodies stop at the beginning of this stage; walls do not.",
   "stage     halt\n  still\n  cycles  10"},
  {"remove", NB_IN_STAGE, nothing, "disc N | discs N to M", 0, false, nb_apply_remove,
   "Takes bodies out of the scene at the beginning of this stage, with what energy they have. They no longer move, touch "
   "or weigh anything, and no snapshot shows them; the others keep their numbers. Read from then on, a body that is gone "
   "is where it was last, with all else 0, and its pairs are 0. Spheres are `sphere N`, `spheres N to M`.",
   "stage     less\n  remove  disc 8\n  cycles  10"},
  {"reverse", NB_IN_STAGE, nothing, NULL, 1, false, nb_apply_still,
   "All velocities and spins turn round at the beginning of this stage, those of walls too: what has no friction and no "
   "damping goes back the way it came.",
   "stage     back\n  reverse\n  cycles  10"},
  {"gravity centripetal", NB_IN_STAGE | NB_IN_RAMP, centripetal, NULL, 1, false, nb_apply_gravity,
   "Acceleration of all bodies that are free towards a point [R89 6.4.1], instead of `gravity`.",
   "stage     fall\n  gravity centripetal 10 m/s2  about 40 mm 40 mm\n  cycles  10"},
  {"boundary circle", NB_IN_SCENE | NB_IN_STAGE, circle, NULL, 0, false, nb_apply_circle,
   "Bodies whose centres are on this circle or beyond are the assembly's boundary from here on; at first it is held. While it is held or "
   "strained it carries the circle with it, and who comes to more than half cross it belongs to the boundary as well [R89 6.4.1].",
   "boundary  circle 40 mm 40 mm  radius 1 m"},
  {"boundary strain", NB_IN_STAGE, strain, NULL, 0, false, nb_apply_boundary,
   "The centres of the boundary's bodies follow a strain rate about the circle's centre, exactly; they do not turn, and there is no force "
   "between two of them. From this stage on.",
   "stage     squeeze\n  boundary strain -1e-6 per cycle -1e-6 per cycle\n  cycles  10"},
  {"servo isotropic", NB_IN_STAGE | NB_IN_RAMP, pressure, "on REGION|boundary|cell|box by boundary {continuum}|cell|box at most RATE {every N cycles}", 0, false, nb_apply_servo,
   "Adds to the boundary's strain rate, and to the continuum's if it says so, or to the cell's or the box's, what brings the stress of a region, or that on the boundary, in the cell or on the box, to P in all directions: "
   "xx and yy to P, xy to 0 [R89 4.1], which the walls of a box leave alone: they follow its strain rate as with `box strain`, of xx and yy. The gain follows from the contacts' stiffness; `at most` bounds the rates that are added. For this stage.",
   "stage     even\n  servo   isotropic 1 kPa  on boundary  by boundary continuum  at most 1e-6 per cycle\n  cycles  10"},
  {"servo mean", NB_IN_STAGE | NB_IN_RAMP, pressure, "on REGION|boundary|cell|box by boundary {continuum}|cell|box at most RATE {every N cycles}", 1, false, nb_apply_servo,
   "Holds (xx + yy)/2 alone, by a change of area: what the stage's own strain rates do to the shape goes on.",
   "stage     shear\n  servo   mean 1 kPa  on boundary  by boundary  at most 1e-6 per cycle  every 5 cycles\n  cycles  10"},
  {"servo stress", NB_IN_STAGE | NB_IN_RAMP, servo_stress, "on REGION|boundary|cell|box by boundary {continuum}|cell|box at most RATE {every N cycles}", 2, false, nb_apply_servo,
   "Holds single components.",
   "stage     biaxial\n  servo   stress yy 2 kPa  on boundary  by boundary  at most 1e-6 per cycle\n  cycles  10\nstage     walled\n  servo   stress xx 2 kPa yy 1 kPa  on box  by box  at most 1e-6 per cycle\n  cycles  10"},
  {"boundary stress", NB_IN_STAGE, stress, NULL, 1, false, nb_apply_boundary,
   "The boundary's bodies are free, and on each acts the force of a stress on its share of the polygon through their centres. From this "
   "stage on.",
   "stage     load\n  boundary stress 1 kPa 1 kPa\n  cycles  10"},
  {"boundary hold", NB_IN_STAGE, nothing, NULL, 2, false, nb_apply_boundary,
   "The boundary's bodies stand still from this stage on.",
   "stage     rest\n  boundary hold\n  cycles  10"},
  {"boundary none", NB_IN_STAGE, nothing, NULL, 3, false, nb_apply_boundary,
   "There is no boundary from this stage on: its bodies are free again, with the velocity that they have.",
   "stage     loose\n  boundary none\n  cycles  10"},
  {"box strain", NB_IN_STAGE, box_strain, NULL, 0, false, nb_apply_box_strain,
   "The walls of the box follow a strain rate about its middle, exactly; they grow or shrink with it, so that its corners stay closed. From this stage on, until a stage moves one "
   "of them by `wall` or `walls`.",
   "stage     narrow\n  box     strain -1e-6 per cycle 1e-7 per cycle\n  cycles  10"},
  {"continuum strain", NB_IN_STAGE, continuum_strain, NULL, 0, false, nb_apply_continuum,
   "All bodies that are free and no boundary's are carried along with a strain rate about the boundary's centre, or the origin of the page. "
   "Forces and damping change what their velocities are beyond it [R89 4.41, 4.42]. From this stage on.",
   "stage     carry\n  continuum strain -1e-6 per cycle 1e-6 per cycle  shear 1e-7 per cycle\n  cycles  10"},
  {"continuum none", NB_IN_STAGE, nothing, NULL, 1, false, nb_apply_continuum,
   "Nothing is carried along from this stage on, but the boundary.",
   "stage     stop\n  continuum none\n  cycles  10"},
  {"rotation off", NB_IN_STAGE, nothing, NULL, 1, false, nb_apply_rotation,
   "Bodies stop turning when this stage begins, and do not turn from then on.",
   "stage     stiff\n  rotation off\n  cycles  10"},
  {"rotation on", NB_IN_STAGE, nothing, NULL, 0, false, nb_apply_rotation, "They turn again.",
   "stage     roll\n  rotation on\n  cycles  10"},
  {"repeat", NB_IN_STAGE, nothing, "from STAGE N times", 1, false, nb_apply_repeat,
   "The lines from STAGE down to here once more, so often; those stages are called STAGE-2, STAGE-3 and so on.",
   "stage     again\n  cycles  10\nrepeat    from again 2 times"},
  {"contact", NB_IN_PATH, nothing, "disc|sphere R MATERIAL with disc|sphere R MATERIAL | with wall MATERIAL", 0, true,
   nb_apply_contact,
   "The contact on the bench: of two bodies, or of one with a wall. They just touch at first.",
   "contact   disc 10 mm steel  with wall steel"},
  {"leg", NB_IN_PATH | NB_IN_LEG, leg, "{overlap|normal to|by X} {slip|shear to|by X} {hold normal|shear} {in N steps} | follow FILE",
   0, true, nb_apply_leg,
   "Takes the contact on: the overlap or the normal force, and the slip or the shear force, each along a straight line to "
   "a value or by a difference; default 100 steps. Overlap and slip stay where they are unless something is said; `hold` "
   "holds a force instead. `follow` takes it from point to point of a file of tab-separated columns `approach/m` and "
   "`slip/m`, one step each; the file is found as a page is by `start`.",
   "leg       press  overlap to 10 um  in 5 steps\nleg       load   shear to 15 N  hold normal\n"
   "leg       back   slip by -2 um  overlap by -1 um  in 1 step"},
  {"repeat", NB_IN_LEG, nothing, "from LEG N times", 0, false, nb_apply_repeat,
   "The lines from LEG down to here once more, so often; those legs are called LEG-2, LEG-3 and so on.",
   "repeat    from load 2 times"},
  {NULL, 0, NULL, NULL, 0, false, NULL, NULL, NULL},
};

/* clang-format on */

const struct nb_keyword *nb_keywords(void) { return table; }
