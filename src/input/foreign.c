/* Whole lines of other programs and of textbooks, and the lines of the page language with the same meaning. A hint that
 * finds the line here proposes the line to type, with the numbers and the names that are in it.
 *
 * A row has the place of the line and two patterns. In the first one
 *
 *   word, a|b      stand for themselves, for a or b
 *   {word}         may be left out
 *   CAPITALS       stand for a value or a word: `kinds` says which, by the first letter. A number without unit gets the SI
 *                  unit, if the line has no unit; if the word ends in U, the number has a unit
 *   …, ..., ....   stand for any number of words; in an expectation … is a measure, so it ends before `above`, `below`
 *                  and `expected`
 *
 * In the second one they stand for what they have matched; a line break separates lines. -V is the negative value, 0V zero in the
 * same unit, -|V| the negative of the magnitude. PLACE is what the page can strain, its cell, box or boundary, and CELL
 * and BOX are these two alone; ON is where a servo measures; C and A are a contact and a particle that the page monitors. A row
 * whose names the page lacks does not fit. MATERIAL becomes a material of the page (page_names.c).
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <ctype.h>
#include <string.h>

#include "core/clean.h"
#include "core/names.h"
#include "reader.h"

struct row {
  unsigned where;
  const char *typed, *ours, *note;
};

#define CONTACT_ENDS "until C.overlap below 1e-12 m at most 1000000 cycles"
#define CONTACT_BEGINS "until C.overlap above 0 m at most 1000000 cycles"
#define AFTER_CONTACT                                                                                                  \
  "in a stage that begins during the contact; a stage before it ends at the first cycle of the contact by `until "     \
  "C.overlap above 0 m at most 1000000 cycles`"
#define EXTENSION "strain rates are positive in extension"
#define NOT_EQUAL "`above` and `below` exclude the value itself; for a count, at least 3 is `above 2.5`"
#define OWN_LINE "damping is a line of its own"
#define PLANE "a plane is a wall with two ends, which may be far from all particles"
#define SERVO "at most 1e-6 per cycle"
#define AVERAGE                                                                                                        \
  "`unbalanced.max` is the largest unbalanced force over the largest contact force, stricter than PFC's average "      \
  "ratio, `M.unbalanced.mean` with `region M all`"
#define BOTH (NB_IN_SCENE | NB_IN_STAGE)
/* clang-format off */
static const struct row rows[] = {
  {NB_IN_STAGE, "{move} wall NAME {moves|move|moving|velocity|speed|to|at} left|leftward|leftwards|west {at|with|by|velocity|speed} V", "wall NAME velocity -V 0V", NULL},
  {NB_IN_STAGE, "{move} wall NAME {moves|move|moving|velocity|speed|to|at} right|rightward|rightwards|east {at|with|by|velocity|speed} V", "wall NAME velocity V 0V", NULL},
  {NB_IN_STAGE, "{move} wall NAME {moves|move|moving|velocity|speed|to|at} up|upward|upwards|north {at|with|by|velocity|speed} V", "wall NAME velocity 0V V", NULL},
  {NB_IN_STAGE, "{move} wall NAME {moves|move|moving|velocity|speed|to|at} down|downward|downwards|south {at|with|by|velocity|speed} V", "wall NAME velocity 0V -V", NULL},
  {NB_IN_STAGE, "wall south velocity V", "wall south velocity 0V V", NULL},
  {NB_IN_STAGE, "wall north velocity V", "wall north velocity 0V V", NULL},
  {NB_IN_STAGE, "wall east velocity V", "wall east velocity V 0V", NULL},
  {NB_IN_STAGE, "wall west velocity V", "wall west velocity V 0V", NULL},
  {NB_IN_STAGE, "{move} wall NAME {velocity|speed} vx|x V", "wall NAME velocity V 0V", NULL},
  {NB_IN_STAGE, "{move} wall NAME {velocity|speed} vy|y V", "wall NAME velocity 0V V", NULL},
  {NB_IN_STAGE, "until contact lost|loss|breaks|broken|ends|end|over|separates|separation|opens|open|gone|releases {at} {most} {N} {cycles}", CONTACT_ENDS, AFTER_CONTACT},
  {NB_IN_STAGE, "until {the} end|loss {of} {the} contact|collision|impact {at} {most} {N} {cycles}", CONTACT_ENDS, AFTER_CONTACT},
  {NB_IN_STAGE, "until separation|separated|rebound|detachment|detached|no|lost {contact} {at} {most} {N} {cycles}", CONTACT_ENDS, AFTER_CONTACT},
  {NB_IN_STAGE, "until {first} contact|impact|touch|touches|collision|hit|hits|bounce {begins|begin|starts|start|made} {at} {most} {N} {cycles}", CONTACT_BEGINS, "the end of the contact is `" CONTACT_ENDS "`, in the next stage"},
  {NB_IN_STAGE, "until apex|top|highest|maximum {point|height} {at} {most} {N} {cycles}", "until A.vy below 0 m/s at most 1000000 cycles", "in a stage that begins after the rebound"},
  {BOTH, "{set|model} gravity {down|downward|downwards} G", "gravity 0G -|G|", NULL},
  {BOTH, "{set|model} gravity GX GY", "gravity GX GY", NULL},
  {BOTH, "{set|model} gravity 0 0 GZ", "gravity 0GZ GZ", "the simulation is in the plane, with y up"},
  {BOTH, "{set|model} gravity GX GY 0", "gravity GX GY", "the simulation is in the plane, with y up"},
  {BOTH, "fix … gravity G vector 0 0 -1", "gravity 0G -G", NULL},
  {BOTH, "fix … gravity G vector 0 -1 0", "gravity 0G -G", NULL},
  {BOTH, "gravity|incline|inclined|slope {inclined|incline|slope} {angle|at|by|of} {angle} AZ", "gravity (9.81 m/s2*sin(AZ)) (-9.81 m/s2*cos(AZ))", "gravity on a slope along x"},
  {NB_IN_STAGE, "{model} cycle|run|iterate|steps|step|solve N {cycles|steps}", "cycles N", NULL},
  {NB_IN_STAGE, "cycles N {steps|cycles}", "cycles N", NULL},
  {NB_IN_STAGE, "{model} run|solve|cycle|cycles|duration|time|for {for|elastic} {time} TU", "until stage.time above TU at most 1000000 cycles", NULL},
  {NB_IN_STAGE, "{model} run|solve {elastic} time T", "until stage.time above T at most 1000000 cycles", NULL},
  {NB_IN_STAGE, "{model} solve {mech|mechanical} {elastic} aratio|ratio|ratio-average|ratio_average|average|unbalanced|unbal {ratio} {below} Q {at} {most} {N} {cycles}", "until unbalanced.max below Q and energy.kinetic below 1 nJ and contacts above 0 at most 1000000 cycles", AVERAGE},
  {BOTH, "stage NAME {for|of|lasts} {time|duration} TU", "stage NAME\nuntil stage.time above TU at most 1000000 cycles", NULL},
  {BOTH, "stage NAME {for|of|lasts} N cycles|steps", "stage NAME\ncycles N", NULL},
  {NB_IN_SCENE, "{model} cycle|run|iterate|steps|solve N", "stage load\ncycles N", "cycles belong to a stage, below the scene"},
  {BOTH, "{set|model} timestep|dt|time_step|time-step|set_dt|set_timestep {=} T", "step T", NULL},
  {BOTH, "step TIME", "step TIME", "or `step 0.2 of stable`"},
  {BOTH, "{set|model} timestep|dt|step auto|automatic|adaptive", "step 0.2 of stable", NULL},
  {NB_IN_STAGE, "thermo|history|hist|output|log|print {interval|every} N {cycles|steps}", "record every N cycles", NULL},
  {NB_IN_SCENE, "history|hist|trace|track|print|plot|output QUANTITY", "record QUANTITY", NULL},
  {NB_IN_SCENE, "history|hist {id} {N} {mechanical|ball} unbal|unbalanced|unbalanced-max|unbalanced-maximum|unbalanced-average|unbalanced_force {force}", "record unbalanced.max", NULL},
  {NB_IN_SCENE, "history|hist {id} {N} {ball} energy|kinetic|energy-kinetic|kinetic_energy {energy}", "record energy.kinetic", NULL},
  {NB_IN_SCENE, "history|hist {id} {N} wall NAME force|forces|reaction|contactforce", "monitor F wall NAME\nrecord F.fx F.fy", NULL},
  {NB_IN_SCENE, "measure {create} {id} {N} {circle} {at|position|centre|center} X Y {radius|rad|r} R", "region M circle X Y radius R", "then for example `record M.porosity M.coordination M.stress.mean`"},
  {NB_IN_SCENE, "measure {create} {id} {N} {circle} radius|rad|r R {at|position|centre|center} X Y", "region M circle X Y radius R", "then for example `record M.porosity M.coordination M.stress.mean`"},
  {NB_IN_SCENE, "monitor NAME region|measure {circle} X Y radius R", "region NAME circle X Y radius R", "then for example `record NAME.stress.mean`"},
  {NB_IN_SCENE, "monitor NAME region|measure {box} X Y {to} XE YE", "region NAME box X Y to XE YE", "then for example `record NAME.stress.mean`"},
  {NB_IN_SCENE, "{wall} {NAME} plane {NAME} X Y normal 0 1|-1 WORD", "wall NAME (X-1 m) Y to (X+1 m) Y WORD", PLANE},
  {NB_IN_SCENE, "{wall} {NAME} plane {NAME} X Y normal 1|-1 0 WORD", "wall NAME X (Y-1 m) to X (Y+1 m) WORD", PLANE},
  {NB_IN_SCENE, "measure all|everything|whole {sample|assembly}", "region M all", "then for example `record M.porosity M.coordination M.stress.mean`"},
  {NB_IN_SCENE, "region NAME block X XE Y YE …", "region NAME box X Y to XE YE", "it only measures, and particles are placed by `fill` or `lattice`"},
  {NB_IN_SCENE, "ball|disk|particle|grain|disc {create} {id} {N} {at|position} X Y {radius|rad|r} R {WORD}", "disc X Y radius R WORD", NULL},
  {NB_IN_SCENE, "ball|disk|particle|grain|disc {create} {id} {N} radius|rad|r R {at|position} X Y {WORD}", "disc X Y radius R WORD", NULL},
  {NB_IN_SCENE, "ball|disk|particle|grain|disc {create} {id} {N} {at|position} X Y diameter|diam|d D {WORD}", "disc X Y radius D/2 WORD", NULL},
  {NB_IN_SCENE, "sphere {create} {id} {N} {at|position} X Y {radius|rad|r} R {WORD}", "sphere X Y radius R WORD", NULL},
  {NB_IN_SCENE, "sphere {create} {id} {N} radius|rad|r R {at|position} X Y {WORD}", "sphere X Y radius R WORD", NULL},
  {NB_IN_SCENE, "sphere {create} {id} {N} {at|position} X Y diameter|diam|d D {WORD}", "sphere X Y radius D/2 WORD", NULL},
  {NB_IN_SCENE, "disc … diameter|diam D ...", "disc … radius D/2 ...", NULL},
  {NB_IN_SCENE, "sphere … diameter|diam D ...", "sphere … radius D/2 ...", NULL},
  {NB_IN_SCENE, "lattice … diameter|diam D ...", "lattice … radius D/2 ...", NULL},
  {NB_IN_SCENE, "lattice … NX x|times|* NY ...", "lattice … NX by NY ...", NULL},
  {NB_IN_SCENE, "wall NAME {at|horizontal|plane} {at} y {at|=} Y {WORD}", "wall NAME -1 m Y to 1 m Y WORD", NULL},
  {NB_IN_SCENE, "wall NAME {at|vertical|plane} {at} x {at|=} X {WORD}", "wall NAME X 1 m to X -1 m WORD", NULL},
  {NB_IN_SCENE, "create_atoms {N} random N …", NB_RANDOM_PACKING, NULL},
  {NB_IN_SCENE, "create_atoms N single|1 X Y {Z}", "disc X Y radius 5 mm MATERIAL", NULL},
  {NB_IN_SCENE, "{model} domain|walls|wall {extent|generate|create} {box|block} X Y to XE YE {WORD}", "box X Y to XE YE WORD", NULL},
  {NB_IN_SCENE, "{model} domain|container {extent} X XE Y YE {Z} {ZE} condition|boundary periodic …", "periodic cell X Y to XE YE", NULL},
  {NB_IN_SCENE, "{model} domain|container|walls|wall|box {extent|generate|create} {box|block} X XE Y YE {WORD}", "box X Y to XE YE WORD", NULL},
  {NB_IN_SCENE, "box X Y XE YE {WORD}", "box X Y to XE YE WORD", NULL},
  {NB_IN_SCENE, "{model} domain {extent} X XE {condition|boundary} periodic …", "periodic cell X X to XE XE", NULL},
  {NB_IN_SCENE, "{model} domain {extent} X XE", "box X X to XE XE MATERIAL", NULL},
  {NB_IN_SCENE, "container|domain X Y to XE YE {WORD}", "box X Y to XE YE WORD", NULL},
  {NB_IN_SCENE, "box {width} X by|height|x|times Y {WORD}", "box 0X 0Y to X Y WORD", NULL},
  {NB_IN_SCENE, "periodic|pbc {boundary|boundaries|x|xy|in|domain|box} {=} {x} X Y to XE YE", "periodic cell X Y to XE YE", NULL},
  {NB_IN_SCENE, "periodic|pbc {boundary|boundaries|in|domain} {x} {from} X {to} XE", "periodic cell X X to XE XE", "a cell is always periodic in x and in y"},
  {NB_IN_SCENE, "periodic|pbc boundary|boundaries|x|y|xy|in|on|yes|true|domain|box …", "periodic cell 0 m 0 m to 1 m 1 m", "it takes the place of walls, and is always periodic in x and in y"},
  {NB_IN_SCENE, "cell {width} X by|height|x|times Y", "periodic cell 0X 0Y to X Y", NULL},
  {NB_IN_SCENE, "read_data|import FILE", "packing FILE discs MATERIAL", NULL},
  {NB_IN_SCENE, "pair_style gran/hertz/history …", "normal hertz\nshear mindlin", "stiffness and friction are properties of a `material`"},
  {NB_IN_SCENE, "pair_style gran/hooke/history|gran/hooke …", "normal linear\nshear linear", "stiffness and friction are properties of a `material`"},
  {NB_IN_SCENE, "fix … wall/gran … yplane Y …", "wall floor -1 m Y to 1 m Y MATERIAL", NULL},
  {NB_IN_SCENE, "fix … wall/gran … xplane X …", "wall side X 1 m to X -1 m MATERIAL", NULL},
  {NB_IN_STAGE, "velocity all {set|zero} 0|zero {0} {0}", "zero velocities", NULL},
  {BOTH, "{viscous} damping {viscous|dp_nratio|contact} Q", "damping ratio Q", "a fraction of critical damping at contacts"},
  {BOTH, "dp_nratio|damping_ratio Q", "damping ratio Q", "a fraction of critical damping at contacts"},
  {BOTH, "{damping} restitution|cor {coefficient} Q", "damping ratio RESTITUTION", "the fraction of critical damping with which two particles have this restitution"},
  {NB_IN_SCENE, "material … restitution|cor|en Q ...", "material … ...\ndamping ratio RESTITUTION", OWN_LINE},
  {NB_IN_SCENE, "material … dp_nratio|damping|damping_ratio|gamma_n {ratio} Q ...", "material … ...\ndamping ratio Q", OWN_LINE},
  {NB_IN_SCENE, "material … friction angle AZ ...", "material … friction (tan(AZ)) ...", NULL},
  {NB_IN_SCENE, "material … friction_angle AZ ...", "material … friction (tan(AZ)) ...", NULL},
  {NB_IN_SCENE, "material … poisson|poissons|poisson's ratio Q ...", "material … poisson Q ...", NULL},
  {NB_IN_SCENE, "material … young|youngs|young's modulus P ...", "material … young P ...", NULL},
  {NB_IN_SCENE, "material … shear|shear_modulus|G {modulus} P poisson|poisson_ratio|nu Q ...", "material … young (2*P*(1+Q)) poisson Q ...", NULL},
  {NB_IN_SCENE, "material … kn K kratio Q ...", "material … kn K ks (K / Q) ...", "PFC's kratio is kn over ks"},
  {NB_IN_STAGE, "{apply|keep|hold} confining|confinement|isotropic|hydrostatic|cell {pressure|stress|compression} {of|at|to} P", "servo isotropic P on ON through PLACE " SERVO, NULL},
  {NB_IN_STAGE, "{apply|keep|hold} pressure|stress {of|at|to} P", "servo isotropic P on ON through PLACE " SERVO, NULL},
  {NB_IN_STAGE, "wall|walls servo {isotropic} {pressure|stress} {of|at|to} P", "servo isotropic P on ON through PLACE " SERVO, NULL},
  {NB_IN_STAGE, "wall-servo|wall_servo {isotropic} {pressure|stress} {of|at|to} P", "servo isotropic P on ON through PLACE " SERVO, NULL},
  {NB_IN_STAGE, "{apply|keep|hold} lateral|horizontal stress|pressure {of|at|to} P", "servo xx P on ON through PLACE " SERVO, NULL},
  {NB_IN_STAGE, "{apply|keep|hold} axial|vertical stress|pressure|load {of|at|to} P", "servo yy P on ON through PLACE " SERVO, NULL},
  {NB_IN_STAGE, "wall|walls servo west|east|left|right|lateral {pressure|stress} P", "servo xx P on ON through PLACE " SERVO, NULL},
  {NB_IN_STAGE, "wall|walls servo north|south|top|bottom|axial {pressure|stress} P", "servo yy P on ON through PLACE " SERVO, NULL},
  {NB_IN_STAGE, "servo", "servo isotropic 50 kPa on ON through PLACE " SERVO, "for a stress of 50 kPa; `xx P` and `yy P` in place of `isotropic P` control components, and `mean P` controls (xx + yy)/2"},
  {NB_IN_STAGE, "axial|vertical strain {rate} {of|at} EU", "PLACE strain 0EU -|EU|", EXTENSION},
  {NB_IN_STAGE, "axial|vertical strain rate {of|at} E", "PLACE strain 0E -|E|", EXTENSION},
  {NB_IN_STAGE, "strain {axial|vertical} {rate} {of|at} EU", "PLACE strain 0EU -|EU|", EXTENSION},
  {NB_IN_STAGE, "strain {axial|vertical} rate {of|at} E", "PLACE strain 0E -|E|", EXTENSION},
  {NB_IN_STAGE, "lateral|horizontal strain {rate} {of|at} EU", "PLACE strain -|EU| 0EU", EXTENSION},
  {NB_IN_STAGE, "{until} axial|vertical strain {of|at|to|above|below|reaches|is|=} Q {at} {most} {N} {cycles}", "until BOX.strain.height below -|Q| at most 1000000 cycles", "extension is positive, and it counts from the start of the run"},
  {NB_IN_STAGE, "{compress|until} {to|until} porosity {of|to|reaches|is|=} Q {at} {most} {N} {cycles}", "BOX strain -2e-6 per cycle -2e-6 per cycle\nuntil box.porosity below Q at most 1000000 cycles", EXTENSION},
  {NB_IN_STAGE, "{isotropic|isotropically} compress|compression {isotropic|isotropically} {strain} {rate} {of|at|with} EU", "PLACE strain -|EU| -|EU|", EXTENSION},
  {NB_IN_STAGE, "{simple|cell} shear {strain} {rate} {of|at} EU", "CELL strain 0EU 0EU  c12 EU", "simple shear, c12 is the velocity in x per unit of y; `shear E` in place of `c12 E` is pure shear"},
  {NB_IN_STAGE, "history|hist|trace|track|print|plot|output QUANTITY", "record QUANTITY", "in the scene, if no line records it yet; a value is `report QUANTITY max in STAGE`, in a block `expect`"},
  {NB_IN_SCENE | NB_IN_CONTACT_TEST, "material rigid", "material hard rigid", "the name comes first"},
  {NB_IN_SCENE | NB_IN_CONTACT_TEST, "material rigid ...", "material hard ...", "`rigid`, an infinite Young's modulus, cannot be the name"},
  {NB_IN_SCENE, "disc … rotation|rotating|omega|angular_velocity W ...", "disc … spin W ...", NULL},
  {NB_IN_SCENE, "sphere … rotation|rotating|omega|angular_velocity W ...", "sphere … spin W ...", NULL},
  {NB_IN_STAGE, "snapshot forces|force|contacts|particles|chains|force-chains …", "snapshot", "it saves the particles, the walls and the contacts with their forces at the end of the stage; a block `gnuplot` draws them: `nineball --help gnuplot`"},
  {NB_IN_EXPECT, "reference file|data|measured|csv FILE ...", "C.normal at 0.1 s expected 2 N within 2 %", "numbers from a file are typed, one in a line; `nineball list` names the references, which are computed from theory"},
  {NB_IN_EXPECT, "print|show|output|display|log QUANTITY", "report QUANTITY max in STAGE", "or another word such as `last` or `mean`"},
  {NB_IN_EXPECT, "print|show|output|display|log QUANTITY ...", "report QUANTITY ...", NULL},
  {NB_IN_EXPECT, "… at time|t {=} T ...", "… at T ...", NULL},
  {NB_IN_EXPECT, "… at cycle|cycles N ...", "… at N cycles ...", NULL},
  {NB_IN_EXPECT, "… {is|are} not below|less|under {than} ...", "… above ...", NOT_EQUAL},
  {NB_IN_EXPECT, "… {is|are} not above|more|greater|over {than} ...", "… below ...", NOT_EQUAL},
  {NB_IN_EXPECT, "… {is|are} at least ...", "… above ...", NOT_EQUAL},
  {NB_IN_EXPECT, "… {is|are} at most ...", "… below ...", NOT_EQUAL},
  {NB_IN_EXPECT, "1 minus|- QUANTITY {last} above Q", "QUANTITY below (1-Q)", NULL},
  {NB_IN_EXPECT, "1 minus|- QUANTITY {last} below Q", "QUANTITY above (1-Q)", NULL},
  {NB_IN_EXPECT, "1 minus|- QUANTITY {last} expected|is|= Q ...", "QUANTITY expected (1-Q) within (0.01*Q)", "the tolerance is 1 % of Q"},
  {NB_IN_EXPECT, "{the} ratio {of} … to|over|and|by OTHER ... {is} above H", "… expected (1.5*H) of OTHER ... within (0.5*H)", "it allows ratios from H to (2*H), because a ratio has no single bound"},
  {NB_IN_EXPECT, "{the} ratio {of} … to|over|and|by OTHER ... {is} below H", "… expected (0.5*H) of OTHER ... within (0.5*H)", "it allows ratios from 0 to H"},
  {NB_IN_EXPECT, "{the} ratio {of} … to|over|and|by OTHER ... expected|is|=|equals Q ....", "… expected Q of OTHER ... ....", NULL},
  {NB_IN_EXPECT, "… over|divided|/ {by} OTHER ... {is} above H", "… expected (1.5*H) of OTHER ... within (0.5*H)", "it allows ratios from H to (2*H), because a ratio has no single bound"},
  {NB_IN_EXPECT, "… over|divided|/ {by} OTHER ... {is} below H", "… expected (0.5*H) of OTHER ... within (0.5*H)", "it allows ratios from 0 to H"},
  {NB_IN_EXPECT, "… over|divided|/ {by} OTHER ... expected|is|=|equals Q ....", "… expected Q of OTHER ... ....", NULL},
  {NB_IN_EXPECT, "… {is|stays|remains} same|equal|equals|unchanged|identical|=|== {as|to|from|since|with} QUANTITY ...", "… expected 1 of QUANTITY ...", NULL},
  {NB_IN_EXPECT, "… is|are|stays|remains above ...", "… above ...", NULL},
  {NB_IN_EXPECT, "… is|are|stays|remains below ...", "… below ...", NULL},
};
/* clang-format on */

/* ---- values ---- */

/* What a word in capitals stands for, by its first letter: a number, and its unit if the line has none. */
static const struct kind {
  char letter;
  const char *unit; /* "": a number */
} kinds[] = {{'X', "m"},    {'Y', "m"},     {'Z', "m"}, {'R', "m"},  {'D', "m"},   {'V', "m/s"},
             {'G', "m/s2"}, {'W', "rad/s"}, {'T', "s"}, {'P', "Pa"}, {'E', "1/s"}, {'K', "N/m"},
             {'A', ""},     {'Q', ""},      {'N', ""},  {'H', ""}};
/* Words in capitals that stand for a word. */
static const char words[] = " NAME WORD FILE QUANTITY OTHER ";
static const char capitals[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";

enum { BOUND_MAX = 16 };
/* What a word of a pattern has matched: tokens of the line. */
struct bound {
  const char *word;
  size_t length, from, to;
};
struct match {
  const struct nb_reader *reader;
  bool units; /* the line has a unit: then each number but 0 has one */
  size_t end; /* number of the tokens before the source of an expectation */
  struct bound bound[BOUND_MAX];
  size_t count;
};

static const char *next_word(const char *pattern) {
  pattern += strcspn(pattern, " ");
  return pattern + strspn(pattern, " ");
}

static bool is_word(const char *word, size_t length, const char *text) {
  return strlen(text) == length && strncmp(word, text, length) == 0;
}

static bool is_many(const char *word, size_t length) {
  return is_word(word, length, "…") || is_word(word, length, "...") || is_word(word, length, "....");
}

/* True if the word in capitals stands for a word. */
static bool is_text(const char *word, size_t length) {
  char padded[NB_NAME_SIZE];
  snprintf(padded, sizeof padded, " %.*s ", (int)length, word);
  return strstr(words, padded);
}

/* True if the text is one of the words a|b. */
static bool is_one_of(const char *list, size_t length, const char *text) {
  for (size_t at = 0, n; at < length; at += n + 1) {
    n = strcspn(list + at, "|} ");
    if (is_word(list + at, n, text))
      return true;
  }
  return false;
}

static const struct kind *kind_of(char letter) {
  const struct kind *kind = kinds;
  while (kind->letter != letter)
    kind++;
  return kind;
}

/* True if a number without unit may stand for the value. */
static bool may_lack_unit(const struct match *match, const char *word, size_t length, double value) {
  const bool small = !is_word(word, length, "TIME") || value < 1e-2; /* `step 0.2` is a fraction, `step 100` a number */
  return word[length - 1] != 'U' && (match->reader->unitless || value == 0 || (!match->units && small));
}

/* True if the token is a word for which a word in capitals stands. */
static bool is_such_word(const char *word, const char *text) {
  const bool dotted = strchr("QOF", *word); /* a QUANTITY, an OTHER one or a FILE */
  return dotted ? strpbrk(text, "./") && !nb_number_length(text) : nb_is_name(text);
}

/* Number of tokens of a value without dimension: `ks` after a number may be a clause. An angle has its unit. */
static size_t plain_tokens(const struct match *match, char letter, double value, size_t at) {
  const char *const after = at + 1 < match->end ? match->reader->tokens[at + 1].text : "";
  if (letter == 'N')
    return value >= 0 && value <= NB_COUNT_MAX && value == (double)(unsigned long)value;
  if (letter == 'A')
    return strcmp(after, "deg") == 0 ? 2 : 0;
  if (letter == 'H' && !(value > 0)) /* a positive number */
    return 0;
  return nb_unit_without_dimension(after) ? 2 : 1;
}

/* Number of tokens, from `at` on, of the value or the word for which a word in capitals stands; 0: there is none. */
static size_t value_tokens(const struct match *match, const char *word, size_t length, size_t at) {
  const struct nb_token *const token = &match->reader->tokens[at];
  struct nb_unit unit, si;
  double value;
  if (is_text(word, length))
    return is_such_word(word, token->text);
  if (nb_number_read(&value, token->text, 0) != NB_READ)
    return 0;
  const struct kind *const kind = kind_of(*word);
  if (!nb_unit_read(&si, kind->unit))
    return plain_tokens(match, *word, value, at);
  if (at + 1 == match->end || !nb_unit_read(&unit, token[1].text))
    return may_lack_unit(match, word, length, value);
  return nb_dimension_same(unit.dimension, si.dimension) ? 2 : 0;
}

static bool fits(struct match *match, const char *pattern, size_t at);

/* True if the rest of the pattern fits after its first word has taken the tokens from `at` to `to`. */
static bool fits_bound(struct match *match, const char *word, size_t length, size_t at, size_t to, const char *rest) {
  if (match->count == BOUND_MAX)
    return false;
  match->bound[match->count++] = (struct bound){word, length, at, to};
  const bool all = fits(match, rest, to);
  match->count -= !all;
  return all;
}

/* The end of the most tokens, from `at` on, for which a word such as `…` may stand. */
static size_t last_of_many(const struct match *match, const char *word, size_t length, size_t at) {
  static const char relations[] = "above|below|expected";
  const bool measure = match->reader->here == NB_IN_EXPECT && is_word(word, length, "…");
  while (at < match->end && !(measure && is_one_of(relations, strlen(relations), match->reader->tokens[at].text)))
    at++;
  return at;
}

/* True if the pattern fits the tokens from `at` to the end of the line. */
static bool fits(struct match *match, const char *pattern, size_t at) {
  const struct nb_reader *const reader = match->reader;
  const bool optional = *pattern == '{', more = at < match->end;
  const char *const word = pattern + optional, *const rest = next_word(pattern);
  const size_t length = strcspn(word, "} "), upper = strspn(word, capitals);
  if (!*pattern)
    return !more;
  if (is_many(word, length)) {
    bool found = false;
    for (size_t to = at, last = last_of_many(match, word, length, at); to <= last && !found; to++)
      found = fits_bound(match, word, length, at, to, rest);
    return found;
  }
  const size_t taken = !more             ? 0
                       : upper == length ? value_tokens(match, word, length, at)
                                         : is_one_of(word, length, reader->tokens[at].text);
  return (taken && fits_bound(match, word, length, at, at + taken, rest)) || (optional && fits(match, rest, at));
}

/* ---- the proposed line ---- */

static const struct bound *bound_of(const struct match *match, const char *word, size_t length) {
  for (size_t k = 0; k < match->count; k++)
    if (match->bound[k].length == length && strncmp(match->bound[k].word, word, length) == 0)
      return &match->bound[k];
  return NULL;
}

/* Appends a token as it is written: a $NAME with its `$`, unless it is in parentheses. Nothing for the unit that belongs
 * to a $NAME. */
static void append_token(char *text, const struct nb_reader *reader, size_t k, bool inside) {
  const struct nb_token *const it = &reader->tokens[k];
  const char *const line = reader->page->lines[reader->line - 1];
  if (!it->name)
    nb_append(text, NB_HINT_SIZE, "%.80s", it->text);
  else if (k == 0 || it[-1].column != it->column)
    nb_append(text, NB_HINT_SIZE, "%s%s%s",
              strlen(line) >= (size_t)it->column && line[it->column - 1] == '-' ? "-" : "", inside ? "" : "$",
              it->name);
}

static void append_tokens(char *text, const struct nb_reader *reader, size_t from, size_t to) {
  for (size_t k = from; k < to; k++) {
    const size_t before = strlen(text);
    append_token(text, reader, k, false);
    if (strlen(text) > before && k + 1 < to)
      nb_append(text, NB_HINT_SIZE, " ");
  }
}

/* Appends a value; `sign`: 0 zero, - the negative, | the negative of the magnitude; `half`: half of it. */
static void append_value(char *text, const struct match *match, const struct bound *bound, char sign, bool half,
                         bool inside) {
  const struct nb_reader *const reader = match->reader;
  const struct nb_token *const token = &reader->tokens[bound->from];
  char own[NB_HINT_SIZE] = "";
  double value;
  nb_number_read(&value, token->text, 0);
  append_token(own, reader, bound->from, inside);
  const bool negative = *own == '-', minus = sign == '|'   ? (value < 0) == negative && value != 0
                                             : sign == '-' ? !negative && value != 0
                                                           : negative;
  const char *const unit = bound->to - bound->from == 2 ? token[1].text
                           : reader->unitless           ? ""
                                                        : kind_of(*bound->word)->unit;
  if (sign == '0')
    nb_append(text, NB_HINT_SIZE, "0");
  else if (half)
    nb_append(text, NB_HINT_SIZE, "%.10g", value / 2);
  else if (*bound->word == 'N')
    nb_append(text, NB_HINT_SIZE, "%.0f", value);
  else
    nb_append(text, NB_HINT_SIZE, "%s%.60s", minus ? "-" : "", own + negative);
  if (*unit && (!token->name || sign == '0' || half))
    nb_append(text, NB_HINT_SIZE, " %.20s", unit);
}

/* The name of the first monitor of the page that is a contact or a particle; false: there is none. */
static bool find_monitor(char name[NB_NAME_SIZE], const struct nb_page *page, bool contact) {
  const char *rest;
  char of[NB_NAME_SIZE];
  for (size_t k = 1; k <= page->line_count; k++) {
    const bool monitor = nb_page_statement(page, k, "monitor", &rest) && sscanf(rest, " %63s %63s", name, of) == 2 &&
                         nb_is_name(name) && (strcmp(of, "disc") == 0 || strcmp(of, "sphere") == 0);
    if (monitor && (strstr(rest, " with ") != NULL) == contact)
      return true;
  }
  return false;
}

/* Appends the damping ratio with which two particles have the restitution Q, by the normal law of the page. */
static void append_restitution(char *text, const struct match *match) {
  const struct nb_page *const page = match->reader->page;
  const char *rest, *const value = match->reader->tokens[bound_of(match, "Q", 1)->from].text;
  bool hertz = false;
  for (size_t k = 1; k <= page->line_count; k++)
    hertz = hertz || (nb_page_statement(page, k, "normal", &rest) && strstr(rest, "hertz"));
  nb_append(text, NB_HINT_SIZE, "(-%slog(%.20s)/hypot(pi, log(%.20s)))", hertz ? "sqrt(5/6)*" : "", value, value);
}

/* Appends a place of the page: PLACE, CELL, BOX or ON. False: the page lacks it. */
static bool append_place(char *text, const char *place, const char *word, size_t length) {
  const bool cell = is_word(word, length, "CELL"), box = is_word(word, length, "BOX");
  if (!place || (cell && strcmp(place, "cell") != 0) || (box && strcmp(place, "box") != 0))
    return false;
  nb_append(text, NB_HINT_SIZE, "%s", is_word(word, length, "ON") && strcmp(place, "box") == 0 ? "walls" : place);
  return true;
}

/* Appends what a word in capitals without a value stands for. False: the page lacks it. */
static bool append_name(char *text, const struct match *match, const char *word, size_t length) {
  const struct nb_page *const page = match->reader->page;
  static const char places[] = "PLACE|CELL|BOX|ON";
  char name[NB_NAME_SIZE];
  snprintf(name, sizeof name, "%.*s", (int)length, word);
  if (is_one_of(places, strlen(places), name))
    return append_place(text, nb_page_place(page), word, length);
  if (length == 1 && word[1] == '.' && strchr("AC", *word)) {
    if (!find_monitor(name, page, *word == 'C'))
      return false;
    nb_append(text, NB_HINT_SIZE, "%s", name);
  } else if (is_word(word, length, "RESTITUTION")) {
    append_restitution(text, match);
  } else {
    nb_append(text, NB_HINT_SIZE, "%s", strcmp(name, "WORD") == 0 ? "MATERIAL" : name);
  }
  return true;
}

/* Appends a character of the second pattern; a line break ends a line, and blanks before it are left out. */
static void append_character(char *text, char c) {
  size_t end = strlen(text);
  while (c == '\n' && end > 0 && text[end - 1] == ' ')
    text[--end] = '\0';
  nb_append(text, NB_HINT_SIZE, c == '\n' ? "` and `" : "%c", c);
}

/* Appends the value or the tokens for a word of the second pattern; returns the length of the word there. */
static size_t append_bound(char *text, const struct match *match, const struct bound *bound, const char *at,
                           bool inside) {
  const size_t prefix = strncmp(at, "-|", 2) == 0 ? 2 : strchr("-0", *at) != NULL;
  const char *const after = at + prefix + bound->length;
  if (is_many(bound->word, bound->length) || is_text(bound->word, bound->length)) {
    append_tokens(text, match->reader, bound->from, bound->to);
    return bound->length + (bound->from == bound->to && *after == ' ');
  }
  const bool half = strncmp(after, "/2", 2) == 0;
  append_value(text, match, bound, prefix == 2 ? '|' : prefix ? *at : ' ', half, inside);
  return prefix + bound->length + (prefix == 2) + 2 * (size_t)half;
}

/* Length of the word of the second pattern at the beginning of a text: `…`, or capitals after -, 0 or -|. *prefix: the
 * length of what precedes the capitals. 0: no such word. */
static size_t pattern_word(const char *at, size_t *prefix) {
  static const char *const many[] = {"…", "....", "..."};
  *prefix = 0;
  for (size_t k = 0; k < sizeof many / sizeof *many; k++)
    if (strncmp(at, many[k], strlen(many[k])) == 0)
      return strlen(many[k]);
  *prefix = strncmp(at, "-|", 2) == 0 ? 2 : *at == '-' || *at == '0';
  return strspn(at + *prefix, capitals);
}

/* Appends the second pattern of a row, with the values of the line; false: the page lacks a name. */
static bool append_line(char *text, const struct match *match, const char *ours) {
  bool inside = false; /* in parentheses */
  for (const char *at = ours; *at;) {
    size_t prefix;
    const size_t length = pattern_word(at, &prefix);
    const struct bound *const bound = length ? bound_of(match, at + prefix, length) : NULL;
    inside = inside ? *at != ')' || at[1] == ')' : *at == '(';
    if (bound)
      at += append_bound(text, match, bound, at, inside);
    else if (!length || prefix)
      append_character(text, *at++);
    else if (append_name(text, match, at, length))
      at += length;
    else
      return false;
  }
  for (size_t end = strlen(text); end > 0 && text[end - 1] == ' '; end--)
    text[end - 1] = '\0';
  return true;
}

/* Ends a proposed expectation with a value: the tolerance, and the source of the line. */
static void end_expectation(char *text, const struct match *match) {
  if (match->reader->here != NB_IN_EXPECT || !strstr(text, " expected "))
    return;
  nb_append(text, NB_HINT_SIZE, "%s %s", strstr(text, " within ") ? "" : " within 1 %",
            match->end < match->reader->count ? "" : "[SOURCE]");
  append_tokens(text, match->reader, match->end, match->reader->count);
}

/* True if the proposed text is the line as it is: then the mistake is another one. */
static bool is_same(const char *text, const struct nb_reader *reader) {
  char line[NB_HINT_SIZE] = "";
  append_tokens(line, reader, 0, reader->count);
  return strcmp(text, line) == 0;
}

/* True if a number of the line has a unit. */
static bool has_unit(const struct nb_reader *reader) {
  struct nb_unit unit;
  double number;
  bool found = false;
  for (size_t k = 1; k < reader->count; k++)
    found = found || (nb_unit_read(&unit, reader->tokens[k].text) &&
                      nb_number_read(&number, reader->tokens[k - 1].text, 0) == NB_READ);
  return found;
}

/* The unit of a quantity with this name, with or without its owner; NULL: there is none. */
static const char *unit_of(const char *name) {
  struct nb_quantity_row row;
  const char *const dot = strchr(name, '.');
  const char *found = NULL;
  for (size_t k = 0; nb_quantity_row(&row, k) && !found; k++)
    if (strcmp(row.name, name) == 0 || (dot && strcmp(row.name, dot + 1) == 0))
      found = row.unit;
  return found;
}

/* True if the row compares two measures of different dimensions. */
static bool dimensions_differ(const struct match *match) {
  const struct bound *const other = bound_of(match, "OTHER", strlen("OTHER")), *const one =
                                                                                   bound_of(match, "…", strlen("…"));
  if (!other || !one || one->from == one->to)
    return false;
  const struct nb_token *const tokens = match->reader->tokens;
  const char *const a = unit_of(tokens[one->from].text), *const b = unit_of(tokens[other->from].text);
  return a && b && strcmp(a, b) != 0;
}

/* The value of a word of the pattern, in SI; NaN: the row has no such word. */
static double value_of(const struct match *match, const char *word) {
  const struct bound *const bound = bound_of(match, word, strlen(word));
  struct nb_unit unit;
  double value;
  if (!bound)
    return NAN;
  const struct nb_token *const tokens = match->reader->tokens;
  if (bound->from + 1 >= match->reader->count || !nb_unit_read(&unit, tokens[bound->from + 1].text))
    unit = (struct nb_unit){.factor = 1};
  return nb_quantity_read(&value, tokens[bound->from].text, false, &unit) == NB_READ ? value : NAN;
}

/* True if the corners of the row have no area between them: then the line gives them in another order. */
static bool is_without_area(const struct match *match) {
  return value_of(match, "XE") <= value_of(match, "X") || value_of(match, "YE") <= value_of(match, "Y");
}

/* Writes the hint of a row; false: the line is another, or the page lacks a name. */
static bool row_hint(char *hint, struct match *match, const struct row *row) {
  char line[NB_HINT_SIZE] = "", note[NB_HINT_SIZE] = "";
  match->count = 0;
  if (!fits(match, row->typed, 0) || !append_line(line, match, row->ours) || is_same(line, match->reader) ||
      is_without_area(match))
    return false;
  if (dimensions_differ(match))
    return strcpy(hint, NB_OTHER_DIMENSION);
  end_expectation(line, match);
  if (strcmp(row->ours, NB_RANDOM_PACKING) == 0)
    return nb_fill_hint(hint, match->reader);
  if (row->note)
    append_line(note, match, row->note);
  const bool comma = strncmp(note, "or ", 3) == 0 || strncmp(note, "in ", 3) == 0;
  snprintf(hint, NB_HINT_SIZE, "write `%.300s`%s%.200s", line, comma ? ", " : *note ? ": " : "", note);
  return true;
}

const char *nb_foreign_hint(char *hint, const struct nb_reader *reader) {
  const unsigned here = reader->here == NB_IN_START ? NB_IN_SCENE : reader->here;
  if (!reader->page->kind_of || reader->line == 0 || reader->count == 0)
    return NULL;
  struct match match = {.reader = reader, .units = has_unit(reader)};
  while (match.end < reader->count && !(here == NB_IN_EXPECT && *reader->tokens[match.end].text == '['))
    match.end++;
  for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
    if (rows[k].where & here && row_hint(hint, &match, &rows[k]))
      return hint;
  return NULL;
}
