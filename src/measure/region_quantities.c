/* Quantities of a region. Each row names the measure of a quantity and its place in struct nb_region_state.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <string.h>

#include "region.h"

static void parts_of(double parts[], const struct nb_quantity_kind *kind, const struct nb_model *model,
                     const struct nb_monitor *monitor) {
  const size_t count = kind->family == NB_SCALAR ? 1 : kind->family == NB_FOURTH ? 5 : 4;
  memcpy(parts, (const char *)nb_region_measured(model, monitor->a, (enum nb_measure)kind->measure) + kind->at,
         count * sizeof *parts);
}

#define OF(called, of, in, bound, reads, by, member, what)                                                             \
  {                                                                                                                    \
    .name = called, .family = of, .monitors = NB_OF_REGION, .unit = in, .fields = reads, .parts = parts_of,            \
    .measure = by, .at = offsetof(struct nb_region_state, member), .help = what, .bounds = bound                       \
  }
#define ENDS(called, of, in, by, member, what) OF(called, of, in, 0, NB_READS_ENDS, by, member, what)
#define FABRIC(called, of, in, member, what)                                                                           \
  OF(called, of, in, 0, NB_READS_ENDS | NB_READS_LOADS, NB_FABRIC, fabric.member, what)
#define PART(called, which, of_what)                                                                                   \
  ENDS(called, NB_STRESSES, "Pa", NB_STRESS_PARTS, stress.part[which].stress, "stress carried by " of_what),           \
      ENDS(called ".fraction", NB_SCALAR, "1", NB_STRESS_PARTS, stress.part[which].fraction,                           \
           "fraction of the deviator carried by " of_what)
#define DIRECTIONS(called, member, what)                                                                               \
  ENDS(called, NB_SCALAR, "1", NB_DIRECTIONS, directions.member, what " [Rothenburg and Bathurst 1989]")
#define MODULUS(called, member, what)                                                                                  \
  OF(called, NB_SCALAR, "Pa", 0, NB_READS_ENDS | NB_BIT(NB_STIFFNESS) | NB_BIT(NB_SHEAR_STIFFNESS), NB_MODULI,         \
     moduli.member, what)
#define COUNT(called, bound, member, what)                                                                             \
  OF(called, NB_SCALAR, "1", NB_AT_LEAST_0 | (bound), NB_READS_TOUCH, NB_COORDINATION, coordination.member, what)
#define LOAD(called, of, in, bound, member, what)                                                                      \
  OF(called, of, in, bound, NB_READS_LOADS, NB_LOADS, loads.member, what)
#define STRAIN(called, of, in, member, what) OF(called, of, in, 0, NB_REQUEST_STRAIN, NB_STRAIN, strain.member, what)
#define SPEED(called, in, member, what) OF(called, NB_SCALAR, in, NB_AT_LEAST_0, 0, NB_SPEEDS, speeds.member, what)
#define CHAIN(called, in, bound, member, what)                                                                         \
  OF(called, NB_SCALAR, in, bound, NB_READS_ENDS | NB_REQUEST_CHAINS, NB_CHAINS, chains.member, what)
#define CHANGED_CONTACTS(called, of, bound, member, what)                                                              \
  OF(called, of, "1", bound, NB_READS_TOUCH | NB_REQUEST_CHANGED_CONTACTS, NB_CHANGED_CONTACTS, member, what)

const struct nb_quantity_kind nb_region_kinds[] = {
    ENDS("stress", NB_STRESSES, "Pa", NB_STRESS, stress.total,
         "mean stress, summed over particles, compression positive: simple shear with `c12` above 0 makes xy negative"),
    ENDS("stress.sinphi", NB_SCALAR, "1", NB_STRESS, stress.sinphi,
         "sine of the mobilized friction angle: deviator over twice the mean stress"),
    ENDS("stress.contacts", NB_STRESSES, "Pa", NB_STRESS_PARTS, stress.contacts, "mean stress, summed over contacts"),
    PART("stress.normal", NB_STRESS_NORMAL, "normal forces"),
    PART("stress.shear", NB_STRESS_SHEAR, "shear forces"),
    PART("stress.fabric", NB_STRESS_FABRIC, "the mean normal force at every contact"),
    PART("stress.variation", NB_STRESS_VARIATION, "normal forces minus their mean"),
    OF("stress.residual", NB_SCALAR, "Pa", NB_AT_LEAST_0, NB_READS_ENDS, NB_STRESS_PARTS, stress.residual,
       "largest difference between `stress` and `stress.contacts`, or between the stress and the sum of its parts; it "
       "consists of rounding errors"),

    FABRIC("fabric", NB_FABRICS, "1", plain.second, "structural anisotropy Phi [R89 4.48]"),
    FABRIC("fabric.fourth", NB_FOURTH, "1", plain.xxxx, "structural anisotropy of fourth order [R89 4.48]"),
    FABRIC("fabric.kk", NB_SCALAR, "1/m2", kk, "F_kk, contact ends times mean radius over volume [R89 4.46]"),
    FABRIC("fabric.normal", NB_FABRICS, "1", normal.second, "Phi weighted by the normal force"),
    FABRIC("fabric.shear", NB_FABRICS, "1", shear.second, "Phi weighted by the magnitude of the shear force"),
    FABRIC("fabric.sliding", NB_FABRICS, "1", sliding.second,
           "Phi of contacts whose shear force is 0.99 of its limit or more"),
    FABRIC("fabric.sliding.fourth", NB_FOURTH, "1", sliding.xxxx,
           "Phi of fourth order of contacts whose shear force is 0.99 of its limit or more"),

    DIRECTIONS("anisotropy.contacts", contacts,
               "coefficient a of the variation of the contact density with the direction"),
    DIRECTIONS("anisotropy.normal", normal,
               "coefficient a_n of the variation of the mean normal force with the direction"),
    DIRECTIONS("anisotropy.shear", shear,
               "coefficient a_t of the variation of the mean shear force with the direction"),
    DIRECTIONS("anisotropy.sinphi", sinphi, "sine of the mobilized friction angle that follows from a, a_n and a_t"),
    MODULUS(
        "modulus.bulk", bulk,
        "bulk modulus, mean stress over area strain, if all particles moved with one uniform strain: an upper bound"),
    MODULUS("modulus.bulk.lower", bulk_lower,
            "bulk modulus if all contact forces increased in the same proportion: a lower bound"),
    MODULUS("modulus.shear", shear,
            "shear modulus for a shear along x and y, deviator over twice the difference of the strains: an upper "
            "bound, as modulus.bulk"),

    OF("area", NB_SCALAR, "m2", NB_AT_LEAST_0, 0, NB_POROSITY, area, "area of the region"),
    OF("porosity", NB_SCALAR, "1", NB_AT_MOST_1, 0, NB_POROSITY, porosity.areal,
       "areal porosity: 1 minus the area of the particles over that of the region; overlaps count twice, and particles "
       "cut by the edge count with the part inside. Without a cell the area of `all` is that of a rectangle around the "
       "particles; the porosity between the walls of a box is box.porosity"),
    OF("porosity.volume", NB_SCALAR, "1", NB_AT_MOST_1, 0, NB_POROSITY, porosity.volume,
       "porosity by volume; the volume is the area times the thickness: mean diameter of spheres, 1 m for discs [R89 "
       "sec. 4.4]"),
    OF("void_ratio", NB_SCALAR, "1", 0, 0, NB_POROSITY, porosity.void_ratio,
       "void ratio e = n/(1 - n), n the areal porosity"),

    COUNT("particles", NB_COUNTED, particles, "number of particles whose centre is inside"),
    COUNT("contacts", NB_COUNTED, contacts, "number of contacts of the particles inside, each counted once"),
    COUNT("coordination", 0, mean, "coordination number: mean number of contacts of a particle inside"),
    COUNT("coordination.mechanical", 0, mechanical,
          "mechanical coordination number: without rattlers and their contacts"),
    COUNT("rattlers", NB_COUNTED, rattlers,
          "number of free particles inside with fewer than two contacts, contacts with rattlers not counted"),

    OF("constraint_ratio", NB_SCALAR, "1", NB_AT_LEAST_0, NB_READS_TOUCH | NB_BIT(NB_SLIDING), NB_CONSTRAINTS,
       constraint_ratio,
       "constraints over degrees of freedom of the free particles, rattlers not counted; 1: statically determinate "
       "[Cundall and Strack 1983]"),

    LOAD("normal", NB_STATISTICS, "N", NB_AT_LEAST_0_BY_LAW, normal, "elastic normal force of the contacts"),
    LOAD("shear", NB_STATISTICS, "N", NB_AT_LEAST_0, shear, "magnitude of the elastic shear force of the contacts"),
    LOAD("contact_stress", NB_STATISTICS, "Pa", NB_AT_LEAST_0_BY_LAW, pressure,
         "normal force over contact area [R89 sec. 4.6]"),
    LOAD("contact_shear", NB_STATISTICS, "Pa", NB_AT_LEAST_0, traction,
         "magnitude of the shear force over contact area [R89 sec. 4.6]"),
    LOAD("contact_ratio", NB_STATISTICS, "1", NB_AT_LEAST_0, ratio,
         "radius of the contact over that of the smaller particle [R89 sec. 4.6]"),
    LOAD("obliquity", NB_STATISTICS, "1", NB_AT_LEAST_0, obliquity,
         "shear force over its limit, of contacts that have one"),
    LOAD("sliding", NB_SCALAR, "1", NB_AT_LEAST_0 | NB_AT_MOST_1, sliding,
         "sliding fraction: contacts whose shear force is at its limit, over all contacts"),
    LOAD("sliding.near", NB_SCALAR, "1", NB_AT_LEAST_0 | NB_AT_MOST_1, near_sliding,
         "fraction of the contacts whose shear force is 0.99 of its limit or more"),
    LOAD("unbalanced.mean", NB_SCALAR, "1", NB_AT_LEAST_0, unbalanced_mean,
         "mean unbalanced force on a free particle over the mean normal force of the contacts; infinite if forces act "
         "but all normal forces are 0, 0 if no force acts"),
    LOAD("unbalanced.force", NB_SCALAR, "N", NB_AT_LEAST_0, unbalanced_force,
         "mean magnitude of the unbalanced force on a free particle"),

    STRAIN("strain", NB_TENSOR, "1", strain,
           "strain fitted by least squares to the displacements of particles, extension positive; xy is half the "
           "engineering shear strain. The particles are those that were in the region when the strain began, at the "
           "start of the run or of the stage that `from` names, rattlers included. The strain of walls is "
           "box.strain.width and box.strain.height"),
    STRAIN("strain.volumetric", NB_SCALAR, "1", volumetric, "volumetric strain xx + yy, expansion positive"),
    STRAIN("strain.rotation", NB_SCALAR, "rad", rotation, "mean rigid rotation of the region, small, counterclockwise"),

    SPEED("speed.mean", "m/s", mean, "mean speed of the free particles inside, relative to the imposed motion"),
    SPEED("speed.max", "m/s", max, "largest speed of the free particles inside, relative to the imposed motion"),
    SPEED("speed.imposed", "m/s", imposed, "mean speed of the imposed motion of the free particles inside"),
    SPEED("speed.ratio", "1", ratio, "speed.mean over speed.imposed [R89 sec. 6.5.1]; 0 without imposed motion"),

    CHAIN("chains", "1", NB_AT_LEAST_0 | NB_COUNTED, count,
          "number of force chains: three or more particles whose major stress is above the mean, in contact along "
          "their major axes"),
    CHAIN("chains.length", "1", NB_AT_LEAST_0, length, "mean number of particles of a force chain"),
    CHAIN("chains.fraction", "1", NB_AT_LEAST_0 | NB_AT_MOST_1, fraction,
          "fraction of the free particles inside that are in force chains"),
    CHAIN("chains.bend", "rad", NB_AT_LEAST_0, bend,
          "mean angle between successive links of force chains: 0 is straight"),

    CHANGED_CONTACTS("contacts.lost", NB_SCALAR, NB_AT_LEAST_0 | NB_COUNTED, lost.count,
                     "number of contacts lost since the stage that `from` names, else the start"),
    CHANGED_CONTACTS("contacts.new", NB_SCALAR, NB_AT_LEAST_0 | NB_COUNTED, gained.count,
                     "number of contacts gained since the stage that `from` names, else the start"),
    CHANGED_CONTACTS("fabric.lost", NB_FABRICS, 0, lost.phi, "Phi of the contacts that contacts.lost counts"),
    CHANGED_CONTACTS("fabric.new", NB_FABRICS, 0, gained.phi, "Phi of the contacts that contacts.new counts"),
    {.name = NULL},
};
