/* "Did you mean": finds the known word nearest to a misspelt one, and the words of the page language for words of other
 * programs and textbooks. Hints and `nineball --help WORD` use both.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <ctype.h>
#include <string.h>

#include "core/clean.h"
#include "reader.h"

/* ---- words of other programs ---- */

bool nb_item(const char **list, char item[NB_NAME_SIZE]) {
  const size_t length = strcspn(*list, ",");
  snprintf(item, NB_NAME_SIZE, "%.*s", (int)length, *list);
  *list += length + strspn(*list + length, ", ");
  return length > 0;
}

/* clang-format off */
#define RANDOM_PACKING \
  NB_RANDOM_PACKING ", `grading mixed 4 mm 67  5 mm 66  6 mm 67` (radius and number of each size) and `fill discs " \
  "box 0 m 0 m to 0.2 m 0.2 m mixed MATERIAL seed 1 attempts 1000 else stop` (in a periodic cell `cell` in place of `box … to …`); " \
  "there is no target porosity: compress with `walls inward 1 mm/s` and `until box.porosity below 0.16 at most 1000000 cycles`"
#define ONE_SERVO "write `servo isotropic 50 kPa on box through box at most 1e-6 per cycle`; `xx P` and `yy P` control components, and `mean P` controls (xx + yy)/2"
#define SERVO_ENDS \
  "a servo ends with its stage: begin a new stage, `stage NAME`, without a line `servo`. The boundary, the cell or the walls then have only the strain rate of a " \
  "`boundary strain`, `cell strain` or `box strain`, and without one they stand still, unless `wall` or `walls` moves them"
#define SERVO_WALLS \
  "`on walls` controls the stress averaged over the walls, and `through box` moves them: `servo isotropic 50 kPa on walls through box at most 1e-6 per cycle`, or `servo yy 50 kPa …` for one direction. The servo strains the whole box, so opposite walls move by equal distances. A biaxial test is `box strain 0 1/s -0.01 1/s` " \
  "with `servo xx 50 kPa on walls through box at most 1e-6 per cycle`. Conditions, `record` and expectations are then on `walls.stress.mean` or `walls.stress.xx`"
#define WALLS_MOVE \
  "opposite walls move in a stage with `box strain 0 1/s -0.1 1/s`, the strain rates in x and y, extension positive; one wall moves by `wall north velocity 0 m/s -1 mm/s`. The stress of the walls is controlled by `servo xx 50 kPa on walls through box at most 1e-6 per cycle`"
#define LOADING \
  "a biaxial test is a stage with `box strain 0 1/s -0.01 1/s` and `servo xx 50 kPa on walls through box at most 1e-6 per cycle`, an isotropic compression is `servo isotropic 50 kPa on walls through box at most 1e-6 per cycle`; in a cell `cell strain 0 1/s -0.01 1/s`, and a servo `on cell through cell`; a boundary of particles has `boundary stress 50 kPa 50 kPa`"
#define FORCE_CHAINS \
  "force chains are drawn from a line `snapshot` in the stage by a block `gnuplot` with the lines `particles = '$STAGE_particles'; contacts = '$STAGE_contacts'` and `load plots.'force-chains.gp'`; `nineball --help gnuplot` shows how"
#define SIMPLE_SHEAR \
  "simple shear at the rate G = 0.1 1/s is `cell strain 0 1/s 0 1/s  c12 0.1 1/s`, where c12 is the velocity in x per unit of y. The clause " \
  "`shear EXY` is pure shear, c12 = c21 = EXY, with the engineering shear rate 2 EXY"
#define WEIGHT \
  "the weight is no quantity, write a formula: `F.fy last  expected (-50*pi*(5 mm)^2*1 m*2650 kg/m3*9.81 m/s2) within 1 % [weight]` for 50 discs and " \
  "the force on a floor, `monitor F wall NAME`, which is below 0; a disc is 1 m thick, and a sphere has the volume 4/3*pi*R^3"
#define THREE_WALLS \
  "a box has four walls; open at the top it is three lines: `wall floor 0 m 0 m to 1 m 0 m MATERIAL`, `wall left 0 m 1 m to 0 m 0 m MATERIAL` and " \
  "`wall right 1 m 0 m to 1 m 1 m MATERIAL`"
#define RANDOM_CIRCLE \
  NB_RANDOM_PACKING ", `grading mixed 4 mm 8  5 mm 8  6 mm 8` (radius and number of each size) and `fill discs circle 0 mm 0 mm " \
  "radius 40 mm mixed MATERIAL seed 1 attempts 1000 else stop`; there is no target porosity"
#define NO_BONDS "there are no bonds and no tension; `cohesion 10 N` in `material` is added to the limit of the shear force"
#define CONSTANT_AREA \
  "the area is constant if the strain rates in x and y are opposite: in a cell `cell strain 0.1 1/s -0.1 1/s`, between walls `box strain 0.1 1/s -0.1 1/s`, " \
  "with a line `boundary circle X Y radius R` in the scene `boundary strain 0.1 1/s -0.1 1/s`"
#define STRAIN_STOPS \
  "a strain rate goes on until a stage changes it; to stop it, write in the next stage `cell strain 0 1/s 0 1/s`, `box strain 0 1/s 0 1/s` or `boundary strain 0 1/s 0 1/s`"
#define NO_ROTATION "`rotation off`, a line of its own below a line `stage NAME`, prevents the rotation of all particles"
/* clang-format on */

/* How a word may be spelt: as in the table, but for `-` and a space; also in capitals, and with `.` for `_`; also in the
 * plural. */
enum spelling { EXACT, LOOSE, SINGULAR };

static bool is_separator(char c) { return c == '-' || c == '_' || c == '.' || c == ' '; }

/* True if b is the letter a of a word in a table. A small letter may be typed as a capital, but not if it stands alone:
 * `E` is a modulus, `e` a void ratio. */
static bool same_letter(char a, char b, bool alone) {
  return a == b || (is_separator(a) && is_separator(b)) || (!alone && a == tolower((unsigned char)b));
}

bool nb_same_spelling(const char *a, const char *b) {
  while (*a && same_letter(*a, *b, false))
    a++, b++;
  return *a == *b;
}

/* True if the letter at `k` of a word in a list stands alone between separators. */
static bool is_alone(const char *at, size_t k) {
  return (k == 0 || is_separator(at[k - 1])) && (!at[k + 1] || is_separator(at[k + 1]));
}

/* True if `word` is one of the words in the list, which have single blanks between them. A page can need thousands of
 * these searches, so only words of the same length are compared. */
static bool has_word(const char *list, const char *word, size_t length, bool loose) {
  for (const char *at = list, *end; at; at = end ? end + 1 : NULL) {
    end = strchr(at, ' ');
    if ((end ? (size_t)(end - at) : strlen(at)) != length)
      continue;
    size_t k = 0;
    while (k < length && (loose ? same_letter(at[k], word[k], is_alone(at, k))
                                : at[k] == word[k] || (at[k] == '_' && (word[k] == '-' || word[k] == ' '))))
      k++;
    if (k == length)
      return true;
  }
  return false;
}

const struct nb_synonym *nb_synonym(const char *word) {
  /* clang-format off */
  static const struct nb_synonym synonyms[] = { /* each word once; `_` stands for `-`, `.` and a space too */
    {"ball balls disk disks particle particles grain grains body bodies", "disc, sphere"}, {"clump clumps multisphere rigid_body superquadric polygon polyhedron", "disc, sphere", "there are no clumps, particles are single discs or spheres: `disc 0 m 0 m radius 5 mm MATERIAL`"}, {"grid mesh regular", "lattice"},
    {"create create_atoms", "fill, lattice, disc, sphere"}, {"generate pack insert distribute pour random cloud makeCloud", "fill", RANDOM_PACKING},
    {"psd gradation size distribution bimodal", "grading"},
    {"facet facets plane plate wallHandler InfiniteWall", "wall"}, {"domain container create_box setXMax setXMin setYMax setYMin", "box, cell", "the domain is `box 0 m 0 m to 1 m 1 m MATERIAL`, or `periodic cell 0 m 0 m to 1 m 1 m`"}, {"pbc", "periodic cell", "periodic boundaries are `periodic cell 0 m 0 m to 1 m 1 m`, in place of walls; a cell is always periodic in x and in y"},
    {"discs", "lattice, fill", "several particles are `lattice discs 20 by 1 radius 5 mm MATERIAL`, or `fill discs`; a line `disc` is one particle"},
    {"spheres", "lattice, fill", "several particles are `lattice spheres 20 by 1 radius 5 mm MATERIAL`, or `fill spheres`; a line `sphere` is one particle"},
    {"brick rblock rblocks block", "disc, sphere, lattice", "particles are discs or spheres: `disc 0 m 0 m radius 5 mm MATERIAL`; a regular packing is `lattice discs hexagonal 20 by 20 radius 5 mm MATERIAL`"},
    {"contact_model cmat pair_style pair_coeff model", "normal, shear", "contact laws are two statements: `normal linear` and `shear linear`, or `normal hertz` and `shear mindlin`; there are no bonds"}, {"property prop attribute set assign", "material, pair, let"},
    {"define fish", "let"}, {"parameter parameters variable", "let, sweep", "one value is `let mu = 0.3`, a run for each of several values is `sweep mu 0.1 0.3`; statements then use `$mu`"}, {"loop foreach for while", "sweep, repeat", "there are no loops: several particles are `lattice discs 20 by 1 radius 5 mm MATERIAL`, a run for each value is `sweep mu 0.1 0.3`, and repeated stages are `repeat from STAGE 3 more times`"}, {"study vary parametric", "sweep"}, {"result results", "report"}, {"bond bonds cement adhesion adhesive tension tensile tensile_strength linearpbond linearcbond parallel_bond contact_bond of_contact_broken of_contact_bond of_contact_bonds of_contact_bonded of_contact_intact of_contact_tension whole_broken whole_bonds whole_bonds.broken whole_broken.bonds", "cohesion", NO_BONDS},
    {"friction_coefficient fric mu xmu slidingFriction", "friction"}, {"friction_angle frictionAngle", "friction", "`friction` is the tangent of the friction angle: `friction (tan(30 deg))`"}, {"coulomb", "friction, linear"}, {"rho dens mass_density", "density"},
    {"material_mass material_weight quantity_mass", "density", "the mass follows from `density D`: it is D pi R^2 times 1 m for a disc, which is 1 m thick, and D 4/3 pi R^3 for a sphere"},
    {"thickness depth", "density", "a disc is a cylinder 1 m thick, so its mass is `density` times pi R^2 times 1 m; another thickness cannot be given: masses, stiffnesses and forces are those of 1 m of thickness"},
    {"young_modulus youngs_modulus youngs modulus emod E", "young"}, {"shear_modulus G", "young", "the shear modulus G gives `young` as 2 G (1 + poisson)"}, {"poisson_ratio poissons_ratio pois nu", "poisson"},
    {"normal_stiffness k_n", "kn"}, {"shear_stiffness tangential_stiffness k_s k_t kt kratio", "ks"}, {"stiffness spring", "kn, ks, young, linear", "stiffness is `kn` and `ks` in `material` or `pair`, or `young` in `material`"},
    {"diameter r", "radius"}, {"g grav acceleration", "gravity"}, {"dt timestep time_step O.dt set_timestep set_dt timestep_NUMBER setTimeStep", "step", "write `step 0.2 of stable`, or a time, `step 10 us`"},
    {"damp viscosity dashpot gamma gamma_n dp_nratio dp_sratio beta", "damping, ratio, stiffness"}, {"neighbor verlet cutoff neighbor_NUMBER neigh_modify", "skin", "the program rebuilds the neighbour list when needed; `skin 0.5 mm` in the scene sets its skin"},
    {"local nonviscous damp_NUMBER damp_local set_damp set_damping local_damping", "mass, ratio", "there is no local damping; write `damping mass 50 1/s`, a rate at which velocities decay as exp(-50 t), or `damping ratio 0.2` at contacts"}, {"global global_damping background_damping", "mass", "damping of all particles is mass-proportional, a rate in 1/s: write `damping mass 50 1/s`, with which velocities decay as exp(-50 t)"}, {"viscous", "ratio", "a fraction of critical damping at contacts is `damping ratio 0.1`; for a restitution of 0.7 write `damping ratio (-log(0.7)/hypot(pi, log(0.7)))` with `normal linear`"},
    {"dump dump_NUMBER dump_modify export vtk write_dump write_data", "record, snapshot", "particles, walls and contacts at the end of a stage are saved by `snapshot`, in the stage; quantities are recorded by `record time A.x A.vx` with `monitor A disc 1`, in the scene"}, {"list list_contacts list_forces list_particles list_balls contact_list contact_dump contacts_list contact_export dump_contacts dump_contact dump_forces print_contacts print_forces write_contacts export_contacts output_contacts", "snapshot", "a stage with the line `snapshot` writes its contacts at its end, each with its two particles and its forces, to the table STAGE-contacts.tsv, and the particles to STAGE-particles.tsv"}, {"draw draw_force draw_chains draw_contacts plot_force plot_chains plot_contacts figure_force", "snapshot, gnuplot", FORCE_CHAINS}, {"plot graph figure", "gnuplot"},
    {"restitution cor material_en", "ratio, impact.restitution", "restitution is a result, not an input; for example, for a restitution of 0.7 write `damping ratio (-log(0.7)/hypot(pi, log(0.7)))` with `normal linear`, `damping ratio (-sqrt(5/6)*log(0.7)/hypot(pi, log(0.7)))` with `normal hertz`"},
    {"rolling rolling_friction rolling_resistance rrolling rrlinear rollingFriction", "rotation off", "there is no rolling resistance; `rotation off`, in a stage, is other physics: it prevents all rotation"},
    {"history hist track trace thermo thermo_NUMBER thermo_style output probe PyRunner", "record, monitor", "write `record time energy.kinetic` in the scene, and `record every 100 cycles` in a stage; quantities of a particle or contact need `monitor A disc 1`, then `record A.vx`"}, {"print echo", "report, record", "a value is `report energy.kinetic max in STAGE`, in a block `expect`; a column of the table is `record time energy.kinetic`, in the scene"}, {"measure measure_create measurement range", "region", "write `region M circle 40 mm 40 mm radius 30 mm`, or `region M all`, then `record M.porosity M.coordination M.stress.mean`"}, {"group", "monitor, region", "there are no groups: `monitor A disc 1` names a particle, `region M all` names the particles of an average"},
    {"run solve go iterate cycle", "cycles, until"}, {"run_NUMBER cycle_NUMBER iterate_NUMBER O.run", "cycles, until", "cycles are part of a stage: a line `stage load`, below it `cycles 1000`, or for a time `until stage.time above 0.2 s at most 1000000 cycles`"}, {"equilibrium converge unbal", "until, unbalanced.max"},
    {"quantity_ratio_average quantity_ratio_avg quantity_average_ratio quantity_mech_ratio_average quantity_mech_ratio_avg quantity_aratio", "unbalanced.mean", "PFC's average ratio is `M.unbalanced.mean`, with `region M all`; `unbalanced.max` is the largest unbalanced force over the largest contact force [CS79]"},
    {"unbalanced unbalanced_force unbalanced_force_ratio unbalanced_ratio mech_ratio mechanical_ratio ratio_maximum ratio_max maximum_ratio", "unbalanced.max", "`unbalanced.max` is the largest unbalanced force over the largest contact force [CS79]; `M.unbalanced.mean`, with `region M all`, is the ratio of the means, PFC's average ratio"},
    {"ratio", "unbalanced.max, damping, poisson"}, {"critical", "ratio, single-contact"}, {"no_contact separation", "contacts"}, {"coordination_number coord cn Z", "coordination"}, {"voidratio", "void_ratio"}, {"solid_fraction packing_fraction volume_fraction quantity_solid_fraction quantity_packing_fraction quantity_volume_fraction quantity_packing.fraction quantity_solid.fraction", "porosity", "the solid fraction is 1 minus the porosity: `region M all`, then `record M.porosity`; for a solid fraction between 0.75 and 0.9 expect `M.porosity max  below 0.25` and `M.porosity min  above 0.1`"},
    {"contact", "damping, monitor, region"}, {"all", "region", "`region M all` measures all particles and contacts"},
    {"calm relax quench", "zero velocities"}, {"unfix free release", "fixed", "a `fixed` particle stays fixed, and nothing releases it; in a stage `remove disc 1` removes it, and `remove wall NAME` a wall that holds particles"},
    {"newton", "momentum.x", "the forces on the two particles of a contact are always equal and opposite: delete the line"}, {"reset_timestep", "stage.time", "the time of a stage is `stage.time`, from 0: `until stage.time above 0.1 s at most 1000000 cycles`; `time` and `cycle` count from the start of the run"},
    {"O.engines engines NewtonIntegrator InteractionLoop", "normal, shear, gravity", "the calculation cycle needs no list: the laws are `normal hertz` and `shear mindlin`, gravity is `gravity 0 m/s2 -9.81 m/s2`, damping is `damping ratio 0.1`"}, {"fix freeze clamp", "fixed", "forces do not move a particle with `fixed`: `disc X Y radius R MATERIAL fixed`; it keeps its `velocity` and `spin`, and two fixed particles have no contact; `rotation off`, in a stage, prevents the rotation of all particles"},
    {"apply load", "gravity, boundary stress, servo, wall"}, {"confine confining confinement membrane pressure", "servo, boundary stress, stress.mean"}, {"goal target", "servo"},
    {"simple_shear shear_simple shear_pure shear_cell shear_rate simple_shear_rate shearing pure_shear engineering_shear", "cell strain, boundary strain, affine strain", SIMPLE_SHEAR},
    {"deform strain strain_rate rate change_box fix_deform", "cell strain, box strain, boundary strain, affine strain", "in a cell write `cell strain -0.1 1/s -0.1 1/s`, or for simple shear `cell strain 0 1/s 0 1/s c12 0.1 1/s`; between walls `box strain 0 1/s -0.1 1/s`; with a line `boundary circle X Y radius R` in the scene `boundary strain 0.1 1/s -0.1 1/s`; `nineball --help strain` compares the four statements"},
    {"compress compression", "box strain, cell strain, boundary strain, walls, servo"}, {"shear_strain strain.shear engineering_shear_strain engineering_strain", "strain.xy, strain.deviator"},
    {"vertical_strain strain_vertical axial_strain quantity_axial_strain quantity_vertical_strain quantity_strain.axial quantity_axial.strain", "strain.yy", "`S.strain.yy`, extension positive, is the strain since the beginning of STAGE with `region S all from STAGE`, since the start of the run with `region S all`; that of walls is `box.strain.height`"}, {"vertical_stress stress_vertical axial_stress", "stress.yy"},
    {"vertical", "y, fy, stress.yy, strain.yy, yy", "y points up"},
    {"axial", "box.strain.height, stage.time, stress.yy, strain.yy", "y points up, so the axial strain of a box is `box.strain.height`, since time 0, extension positive. A stage with `box strain 0 1/s -0.01 1/s` reaches a strain of -5 % at `until stage.time above (log(0.95)/(-0.01 1/s)) at most 1000000 cycles`"},
    {"settle settling deposit deposition", "damping, until, gravity", "particles settle under `gravity 0 m/s2 -9.81 m/s2` with `damping mass 50 1/s` or `damping ratio 0.2`. The stage ends by `until unbalanced.max below 1e-4 and energy.kinetic below 1 nJ and contacts above 0 at most 1000000 cycles`"},
    {"run_out runout spread collapse", "snapshot", "there is no quantity for a run-out distance: a stage with the line `snapshot` saves all particles at its end in STAGE-particles.tsv, and the distance follows from the largest `x/m` there. The place of one particle is `monitor A disc 1`, then `record A.x`"}, {"horizontal lateral", "x, fx, stress.xx, strain.xx, xx", "x points to the right"},
    {"move displace displace_atoms", "wall, walls, transform"}, {"delete kill erase", "remove"},
    {"save checkpoint write_restart continue resume", "start, nineball state", "nothing has to be saved: a second page begins with `start THIS-PAGE stage NAME` and continues with all velocities and contact histories"}, {"restore restart read_restart", "start", "a second page begins with `start PAGE stage NAME`, the name of a page, not of a state file: it uses the saved state of that page, or first runs the page"}, {"read_data import", "start, packing"},
    {"assert compare equals equal is = ==", "expected, within"}, {"tolerance agree", "within"},
    {"maximum largest peak", "max"}, {"tangential", "shear, ks, slip"}, {"end final", "last"}, {"rises rise grows", "increases"}, {"falls fall drops", "decreases"}, {"same", "constant"}, {"between expect_interval", "above, below", "write two lines, one with `above` and one with `below`"}, {"less < <=", "below"}, {"greater more > >=", "above"},
    {"force contact_force forces", "normal, shear, fx, fy"}, {"position pos", "x, y"}, {"displacement disp", "slip, x, y"}, {"shear_displacement tangential_displacement", "slip, impact.slip", "the tangential displacement of a contact is `slip` in a contact test, and `impact.slip` in a scene with `impact`"}, {"vel velocity speed", "velocity, vx, vy, speed.mean, speed.max", "a velocity is given by `velocity VX VY` and recorded as `A.vx` and `A.vy`"},
    {"kinetic kinetic_energy ke E_kin Ekin E_k", "energy.kinetic"}, {"elastic elastic_energy strain_energy energy.elastic energy.strain energy.spring energy.springs spring_energy", "energy.stored"}, {"potential_energy E_pot Epot E_p energy.potential energy.gravitational energy.gravitation gravitational_energy energy.height", "energy.gravity, energy.stored", "`energy.gravity` is the work of gravity since the start, the negative change of the potential energy; the energy of the springs is `energy.stored`"}, {"energy.dissipated energy.dissipation energy.lost energy.loss dissipated_energy", "energy.damped, energy.friction", "the dissipated energy is `energy.damped` plus `energy.friction`, by damping and by friction; record both"},
    {"total total_energy energy.total balance residual energy.error", "energy.balance", "there is no quantity for the total energy; the error of its balance is `energy.balance`: record it, and check `energy.balance max in all` and `energy.balance min in all`, each with `within 0.1 % of energy.kinetic max in all`"},
    {"void voids", "void_ratio"}, {"3d three_dimensions", "disc, sphere", "the simulation is in the plane, x to the right and y up; spheres move in the plane, too"}, {"hertz_mindlin hertzian hertz_material mindlin_rescale gran/hertz/history hertz/history mindlin/history", "normal hertz, shear mindlin"},
    {"micro_slip microslip partial_slip partialslip cattaneo deresiewicz", "mindlin_deresiewicz", "`shear mindlin_deresiewicz` is the exact law with micro-slip; `shear mindlin` has none, so at constant normal force its loops open only when the contact slides"},
    {"hooke hookean gran/hooke/history gran/hooke hooke/history rotlinear linear_history", "normal linear, shear linear"}, {"SI", "units", "`units none`: all numbers are in SI, without units; `units si`: each number has its unit, `5 mm`"}, {"degree degrees", "deg"},
    {"norotation no_rotation irrotational blockedDOFs", "rotation off", NO_ROTATION}, {"false no disable disabled", "off"}, {"true yes enable enabled", "on"},
    {"safety safety_factor", "stable", "write `step 0.2 of stable`"}, {"number count", "grading", "a grading has the number of particles of each radius: `grading sand 2 mm 100  1 mm 400`"},
    /* STATEMENT_WORD: a word in a statement that does not have it */
    {"units_lj units_cgs units_micro units_real units_SI units_Si units_metric", "units", "write `units none` if numbers have no units (they are in SI), or `units si` and a unit after each number: `5 mm`"},
    {"disc_at disc_velocity", "disc", "a statement `disc` takes no number and no word `at`; particles are numbered in the order of their lines. Begin with x and y of the centre: `disc 0 m 0 m radius 5 mm MATERIAL velocity 1 m/s 0 m/s`"},
    {"fix_spin fix_rotation fix_all fix_angle block_rotation block_spin lock_rotation prevent_rotation stop_rotation rotation_none rotation_fixed rotation_false rotation_no rotation_NUMBER rotations_none rotations_fixed rotations_off rotations_no disc_no sphere_no spin_NUMBER", "rotation off", NO_ROTATION},
    {"fixed_spin fixed_rotation disc_off sphere_off spin_off scene_spin", "rotation off, spin", NO_ROTATION "; `spin W` is an angular velocity at the start, which a `fixed` particle keeps: `disc 0 m 0 m radius 5 mm MATERIAL spin 0 rad/s`"},
    {"sphere_at sphere_velocity", "sphere", "a statement `sphere` takes no number and no word `at`; particles are numbered in the order of their lines. Begin with x and y of the centre: `sphere 0 m 0 m radius 5 mm MATERIAL velocity 1 m/s 0 m/s`"},
    {"wall_generate wall_create wall_box wall_block wall_name wall_vertices wall_id wall_group", "wall, box", "four walls are `box 0 m 0 m to 1 m 1 m MATERIAL`; one wall is `wall floor 0 m 0 m to 1 m 0 m MATERIAL`"},
    {"region_NUMBER region_block region_prism region_sphere region_cylinder", "region", "a region is `region M box 0 m 0 m to 1 m 1 m`, or `region M circle 40 mm 40 mm radius 30 mm`; it only measures, and particles are placed by `fill` or `lattice`"},
    {"lattice_triangular lattice_triangle lattice_hex lattice_hcp lattice_sq lattice_cubic lattice_sc lattice_fcc lattice_bcc lattice_rectangular lattice_rect lattice_regular", "hexagonal, square", "the rows of a lattice are `square`, or `hexagonal`, which is triangular: `lattice discs hexagonal 10 by 10 radius 5 mm MATERIAL`"},
    {"lattice_x lattice_times lattice_*", "by", "the number in a row and the number of rows have `by` between them: `lattice discs 10 by 10 radius 5 mm MATERIAL`"},
    {"lattice_at", "lattice", "the centre of the first particle is `from X Y`"},
    {"wall_at wall_normal", "wall", "a wall is a line in the plane between two ends, without `at` and `normal`: `wall floor -1 m 0 m to 1 m 0 m MATERIAL`"},
    {"stage_constant scene_constant constant_volume", "cell strain, box strain", "a cell without a servo keeps its area in simple shear, `cell strain 0 1/s 0 1/s c12 0.1 1/s`; a biaxial test at constant area is `cell strain 0.1 1/s -0.1 1/s`, between walls `box strain 0.1 1/s -0.1 1/s`. A constant stress needs a `servo`"},
    {"lattice_fixed fill_fixed packing_fixed grading_fixed", "fixed", "only a line `disc` or `sphere` has `fixed`: `disc 0 m 0 m radius 5 mm MATERIAL fixed`; a straight row of fixed particles is a `wall`, and all particles along the edge are held by a `boundary circle` and `boundary fixed` in a stage"},
    {"normal_linearpbond shear_linearpbond normal_linearcbond shear_linearcbond normal_parallel_bond shear_parallel_bond normal_bond shear_bond normal_bonded shear_bonded material_pb_kn material_pb_ks material_bond material_tensile_strength material_tension", "cohesion", "there are no bonds and no tension; `cohesion 10 N` in `material` is added to the limit of the shear force: `material MATERIAL cohesion 10 N`"},
    {"region_position region_at region_x region_centre region_center", "region", "the centre follows `circle`, x and y without a word: `region M circle 40 mm 40 mm radius 30 mm`"},
    {"sweep_of sweep_step", "sweep", "a sweep gives values to a name: `sweep f 5 % 10 %`, and the line of the step has the name, `step $f of stable` or `step $f of rayleigh`"},
    {"wall_stop wall_still wall_halt wall_inward", "wall", "in a stage write `wall NAME velocity 0 m/s 0 m/s`, or for all walls `walls stop`"},
    {"wall_sine wall_sin wall_sinus wall_sinusoidal wall_harmonic wall_oscillate wall_amplitude wall_frequency wall_period", "wall", "there is no sine: a wall moves at a constant velocity in each stage, `wall NAME velocity 0 m/s 1 mm/s`, or at one that `ramp wall NAME velocity 0 m/s -1 mm/s` changes linearly; a periodic motion is a few such stages, repeated by `repeat from STAGE 3 more times`"},
    {"walls_velocity walls_speed walls_move", "walls", "`walls inward 1 mm/s` moves the four walls of a box; one wall moves by `wall NAME velocity 0 m/s -1 mm/s`"},
    {"wall_velocity_y wall_velocity_x wall_down wall_up wall_move wall_speed wall_vx wall_vy", "wall", "in a stage write `wall NAME velocity 0 m/s -1 mm/s`"},
    {"fill_NUMBER fill_radius fill_to fill_porosity fill_number fill_count fill_size fill_uniform fill_distribution fix_pour fix_insert/pack packing_random", "fill", RANDOM_PACKING},
    {"grading_uniform grading_to grading_m grading_mm grading_um grading_radius grading_normal grading_gaussian grading_lognormal grading_from grading_range grading_min grading_mean", "grading", "there is no continuous distribution; write several sizes, each a radius and a number of particles: `grading sand 0.4 mm 20  0.45 mm 20  0.5 mm 20  0.55 mm 20  0.6 mm 20`"},
    {"fill_velocity", "fill", "filled particles begin at rest: add moving ones with `disc X Y radius R MATERIAL velocity VX VY` above the `fill`"},
    {"stage_time stage_duration stage_for stage_lasts stage_length setTimeMax", "until", "a stage of 0.1 s ends with `until stage.time above 0.1 s at most 1000000 cycles`"},
    {"stage_steps stage_run stage_hold stage_wait stage_pause", "cycles, until", "a number of cycles is `cycles 1000`, and a time `until stage.time above 0.1 s at most 1000000 cycles`"},
    {"contact_test_sphere contact_test_spheres contact_test_disc contact_test_discs contact_test_wall", "contact", "the two particles are one line, `contact sphere 5 mm MATERIAL with sphere 5 mm MATERIAL`"},
    {"contact_test_force contact_test_shear contact_test_slip contact_test_unload contact_test_load contact_test_cycle contact_test_run contact_test_stage contact_test_normal_force contact_test_displace contact_test_steps contact_test_cycles contact_test_tangential contact_test_move contact_test_until", "segment", "each segment is one line with its own name, `segment load normal to 100 N in 100 steps`, then `segment slide slip to 2 um hold normal in 1000 steps`"},
    {"segment_to segment_by segment_for segment_NUMBER segment_steps segment_tangential segment_displacement segment_normal_force", "segment", "the word after `segment` is its name: `segment load normal to 100 N in 100 steps`, `segment slide slip to 2 um hold normal in 1000 steps`"},
    {"contact_test_cyclic contact_test_loop contact_test_amplitude contact_test_load_cycle contact_test_sine segment_cyclic", "segment, repeat", "five cycles of 1 um are `segment first slip to 1 um hold normal in 100 steps`, `segment back slip to -1 um hold normal in 200 steps`, `segment forth slip to 1 um hold normal in 200 steps` and `repeat from back 4 more times`"},
    {"contact_spheres contact_discs contact_radius contact_at", "contact", "write `contact sphere 5 mm MATERIAL with sphere 5 mm MATERIAL`"},
    {"servo_none servo_off servo_stop servo_end servo_remove servo_release servo_disable servo_delete stop_servo end_servo no_servo remove_servo delete_servo release_servo", "servo, stage", SERVO_ENDS},
    {"servo_twice", "servo", "one line has all components: `servo xx 50 kPa yy 100 kPa on walls through box at most 1e-6 per cycle`, or `servo isotropic 50 kPa on walls through box at most 1e-6 per cycle`"},
    {"gravity_twice", "gravity", "one line has both components, in x and y: `gravity 0 m/s2 -9.81 m/s2`"},
    {"servo_NUMBER servo_pressure servo_stress servo_target servo_force", "servo", ONE_SERVO},
    {"contact_linear contact_hertz", "normal, shear", "contact laws are two statements: `normal linear` and `shear linear`, or `normal hertz` and `shear mindlin`"},
    {"shear_hertz", "shear", "the shear law of elastic spheres is `shear mindlin` or `shear mindlin_deresiewicz`"},
    {"wall_fixed box_fixed", "wall, walls", "a wall does not move unless it has a `velocity` or a `spin`, or a stage moves it"},
    {"remove_walls wall_remove wall_delete wall_off wall_erase wall_kill wall_destroy wall_disable delete_wall delete_walls kill_wall erase_wall destroy_wall", "remove", "a stage removes a wall by its name: `remove wall NAME`"}, {"step_auto", "stable", "write `step 0.3 of stable`, with elastic spheres `step 0.2 of rayleigh`"},
    {"cycles_s cycles_ms cycles_us cycles_second cycles_seconds", "until", "a stage of 2 s ends with `until stage.time above 2 s at most 1000000 cycles`"},
    {"monitor_box monitor_walls", "monitor", "a wall of a box is `monitor B wall south`, `east`, `north` or `west`, then `record B.fx B.fy`; the stress of the box needs no monitor: `record box.stress.xx box.stress.yy`"},
    {"monitor_assembly monitor_sample monitor_particles monitor_system", "region", "averages over all particles are those of a region: `region A all`, then `record A.porosity A.coordination A.stress.mean`"},
    {"monitor_highest monitor_lowest monitor_topmost monitor_uppermost monitor_last monitor_first", "monitor", "a particle is named by its number, `monitor T disc 1`: particles are numbered in the order of the lines of the page, those of a lattice row by row upward, so the last disc of a lattice of 10 by 4 is disc 40, if the lattice is the first line with particles"},
    {"monitor_contact", "monitor", "a contact is named by its two partners: `monitor C disc 1 with disc 2`"},
    {"servo_wall servo_walls servo_west servo_east servo_north servo_south servo_left servo_right servo_sides servo_lateral servo_box", "servo", SERVO_WALLS},
    {"wall_servo walls_servo wall_activate", "servo", SERVO_WALLS}, {"servo_m servo_mm servo_m/s servo_mm/s servo_um/s servo_cm/s", "servo", "the limit is a strain rate, the largest one that the servo adds: `at most 0.1 1/s`"},
    {"walls_east walls_west walls_north walls_south walls_left walls_right walls_top walls_bottom walls_vertical walls_horizontal walls_lateral walls_axial walls_strain walls_rate walls_compress", "box strain, wall", WALLS_MOVE},
    {"stage_axial stage_lateral stage_vertical stage_horizontal stage_biaxial stage_triaxial stage_uniaxial stage_oedometer stage_consolidate stage_consolidation stage_isotropic stage_stress stage_confining stage_confine stage_pressure stage_compress stage_compression stage_loading stage_deviator stage_deviatoric shear_biaxial shear_triaxial shear_direct shear_box shear_test shear_to", "box strain, servo", LOADING},
    {"wall_force wall_load wall_pressure wall_stress wall_traction wall_weight walls_force walls_load walls_pressure walls_stress", "servo", "a wall has no force control: it stands still or has a velocity. A servo controls the mean stress of the walls: `servo yy 100 kPa on walls through box at most 1e-6 per cycle`"},
    {"snapshot_end snapshot_last snapshot_final snapshot_at snapshot_in snapshot_on snapshot_after snapshot_every", "snapshot", "write `snapshot` alone: the program takes the snapshot at the end of the stage or segment"},
    {"stop_wall stop_walls stop_all stop_box", "wall, walls", "in a stage write `walls stop`, or for one wall `wall NAME velocity 0 m/s 0 m/s`"},
    {"until_equals until_equal until_= until_== until_is until_reaches until_to until_until", "until", "a condition has `above` or `below`: `until stage.time above 0.1 s at most 1000000 cycles`; the end of all contacts is `until contacts below 1 at most 1000000 cycles`"},
    {"until_within until_between", "until", "a condition has `above` or `below`, and a range has two: `until stage.time above 0.1 s and energy.kinetic below 1 mJ at most 1000000 cycles`"},
    {"until_at", "until", "a condition has `above` or `below`: `until stage.time above 0.1 s at most 1000000 cycles`, or, to wait for rest, `until unbalanced.max below 1e-4 and energy.kinetic below 1 nJ and contacts above 0 at most 1000000 cycles`"},
    {"until_rest until_equilibrium until_static until_steady until_settled until_quiet until_converged until_relaxed stage_equilibrate stage_settle stage_rest", "until, unbalanced.max", "at rest the contact forces balance: `until unbalanced.max below 1e-4 and energy.kinetic below 1 nJ and contacts above 0 at most 1000000 cycles`"},
    {"until_cycles until_cycle", "cycles", "a number of cycles is `cycles 1000`"},
    {"until_< until_<= until_less until_under until_smaller", "below", "a condition is `QUANTITY below VALUE`"}, {"until_> until_>= until_greater until_over until_more until_exceeds", "above", "a condition is `QUANTITY above VALUE`"},
    {"scene_report stage_report scene_expected stage_expected scene_reference stage_reference", "report, expected, reference", "an expectation or a report belongs in a block `expect`, after the block `scene`: for example `report energy.kinetic max in STAGE`"},
    {"scene_load", "start", "a page that continues from another begins with `start PAGE stage NAME`; a load on particles is `gravity`, or in a stage `boundary stress` or `servo`"},
    {"cell_xy cell_shear cell_simple_shear cell_c12 cell_velocity cell_deform cell_engineering_shear", "cell strain", SIMPLE_SHEAR},
    {"cell_rate cell_xx cell_yy cell_axial cell_volumetric", "cell strain", "two rates follow `cell strain`, those in x and y: `cell strain 0 1/s -0.1 1/s` compresses in y; " SIMPLE_SHEAR},
    {"box_rate box_xx box_yy box_axial box_volumetric box_width box_height", "box strain", "two rates follow `box strain`, those in x and y: `box strain 0 1/s -0.1 1/s` compresses in y"},
    {"boundary_sphere boundary_disc", "boundary", "`boundary fixed` holds all particles of the boundary; one particle is held by `fixed` in its own line of the scene: `disc X Y radius R MATERIAL fixed`"},
    {"boundary_shear boundary_c12", "boundary strain", "simple shear at the rate G = 0.1 1/s is `boundary strain 0 1/s 0 1/s  c12 0.1 1/s`; the clause `shear EXY` is pure shear, c12 = c21 = EXY"},
    {"shear_exact shear_deresiewicz shear_history", "shear", "the exact law of Mindlin and Deresiewicz is `shear mindlin_deresiewicz`"},
    {"model_new model_domain", "box, cell", "a page needs no such line; the domain is `box 0 m 0 m to 1 m 1 m MATERIAL`, or `periodic cell 0 m 0 m to 1 m 1 m`"},
    {"model_gravity set_gravity", "gravity", "write `gravity 0 m/s2 -9.81 m/s2`"}, {"model_calm", "zero velocities", "in a stage write `zero velocities`"},
    {"model_large_strain model_largestrain model_title model_random model_deterministic", "units", "a page needs no such line: delete it; large displacements and rotations are always computed; `nineball --help scene` lists the statements"},
    {"model_solve model_cycle model_step stage_solve scene_solve scene_run scene_cycle minimize", "until, cycles", "in a stage write `cycles 1000`, or `until unbalanced.max below 1e-4 and energy.kinetic below 1 nJ and contacts above 0 at most 1000000 cycles`"},
    {"solve_ratio solve_ratio_average solve_aratio solve_average", "until, unbalanced.mean", "in a stage write `until M.unbalanced.mean below 1e-4 and contacts above 0 at most 1000000 cycles`, with `region M all` in the scene: PFC's average ratio. `unbalanced.max`, the largest unbalanced force over the largest contact force, is stricter"},
    {"model_save model_restore", "start", "nothing has to be saved: a second page begins with `start THIS-PAGE stage NAME`"},
    {"contact_cmat contact_method contact_linearpbond", "normal, shear", "contact laws are two statements: `normal linear` and `shear linear`, or `normal hertz` and `shear mindlin`; there are no bonds"},
    {"ball_generate ball_distribute", "fill", RANDOM_PACKING}, {"ball_create O.bodies.append atom_style", "disc, sphere", "a particle is `disc 0 m 0 m radius 5 mm MATERIAL`, or `sphere` in place of `disc`"},
    {"ball_attribute ball_property scene_mass disc_density disc_kn disc_friction disc_young sphere_density sphere_kn sphere_friction sphere_young species FrictMat ViscElMat LinearViscoelasticFrictionSpecies HertzianViscoelasticMindlinSpecies disc_mass sphere_mass", "material", "density and stiffness are properties of a material: `material steel density 7800 kg/m3 kn 1 MN/m ks 1 MN/m friction 0.3`"},
    {"translation disc_translation disc_x disc_y sphere_translation sphere_x sphere_y", "fixed", "the centre is written without the words x and y: `disc 0 m 0 m radius 5 mm MATERIAL`; `fixed` in this line keeps the centre, no direction can be fixed alone, and `rotation off` in a stage prevents all rotation"},
    {"damping_off damping_no damping_zero damping_false damping_disable damping_disabled", "damping", "without damping write `damping none`"},
    {"damping_of damping_fraction damping_coefficient", "ratio", "a fraction of critical damping is `damping ratio 0.1`"},
    {"gravity_angle gravity_deg gravity_rad gravity_degrees gravity_down gravity_inclined", "gravity", "gravity has its components in x and y: on a slope of 30 degrees, along x, write `gravity (9.81 m/s2*sin(30 deg)) (-9.81 m/s2*cos(30 deg))`"},
    {"gravity_off gravity_none", "gravity", "without gravity write `gravity 0 m/s2 0 m/s2`, or no such line"},
    {"boundary_servo", "servo", "a servo of the boundary is for example `servo isotropic 100 kPa on boundary through boundary at most 1e-6 per cycle`"},
    {"stage_start scene_start contact_test_start", "start", "a page has one `start`, its first statement; only `units`, `let` and `sweep` may precede it"},
    {"remove_all", "remove", "particles are removed by their numbers: `remove discs 1 to 20`"},
    {"walls_all", "walls", "`walls stop` alone stops all walls, those outside the box too"},
    {"quantity_position quantity_positions quantity_trajectory quantity_trajectories", "snapshot, monitor", "a stage with the line `snapshot` saves all particles at its end; the path of one particle is `monitor P disc 1`, then `record P.x P.y`"},
    {"fix_press fix_servo", "servo, boundary, cell, box", "a pressure is kept by a `servo`, and a strain rate is given to a `cell`, a `boundary` or a `box`: for example `servo isotropic 100 kPa on cell through cell at most 1e-6 per cycle`"},
    {"integrator leapfrog scene_integrator scene_integration scene_integrate scene_leapfrog scene_scheme scene_run_style stage_integrator stage_integration stage_integrate", "step", "there is one integrator, leapfrog: delete the line"},
    {"step_collision_time step_collision_duration step_contact_time step_contact_duration step_time step_duration", "collision", "a step is a fraction of the duration of a collision, `step 0.1 of collision`, or a time, `step 10 us`"},
    {"packing_radius packing_porosity packing_mm packing_m packing_to", "fill", RANDOM_PACKING},
    {"packing_in packing_circle", "fill", RANDOM_CIRCLE},
    {"boundary_rate boundary_xx boundary_yy boundary_axial boundary_volumetric", "boundary strain", "two rates follow `boundary strain`, those in x and y: `boundary strain 0.1 1/s -0.1 1/s`, with a line `boundary circle X Y radius R` in the scene"},
    {"area_constant area_fixed area_conserved constant_area stage_area", "cell strain, box strain, boundary strain", CONSTANT_AREA},
    {"strain_stop strain_off strain_none strain_zero strain_end cell_stop cell_off cell_none box_stop box_off box_none boundary_stop boundary_off stop_strain stop_cell stop_boundary", "cell strain, box strain, boundary strain", STRAIN_STOPS},
    {"record_s record_ms record_us record_ns record_second record_seconds", "record", "the interval is a number of cycles, the time over the step: `record every 100 cycles`"},
    {"sweep_to", "sweep", "a sweep lists each value: `sweep mu 0.1 0.3 0.5`"},
    {"disc_force disc_moment sphere_force sphere_moment", "gravity, wall, boundary stress", "no force can be given to one particle: forces come from contacts, `gravity` and, in a stage, `boundary stress`"},
    {"disc_omega sphere_omega", "spin", "the angular velocity of a particle is `spin 1 rad/s`"},
    {"disc_name disc_id disc_group sphere_name sphere_id sphere_group", "monitor", "particles have no names, but numbers in the order of their lines: `monitor A disc 1` is the first one"},
    {"scene_dimension scene_processors scene_comm_modify scene_comm_style scene_package scene_suffix scene_undump scene_thermo_modify scene_setDimension scene_fragment scene_program", "units", "a page needs no such line: delete it; `nineball --help scene` lists the statements"},
    {"scene_seed stage_seed", "seed", "each `fill` has its own seed of random numbers: `fill discs box 0 m 0 m to 0.2 m 0.2 m GRADING MATERIAL seed 1 attempts 1000 else stop`"},
    {"scene_energy", "record", "energies are recorded: `record energy.kinetic energy.stored energy.balance`"},
    {"box_frictionless wall_frictionless disc_frictionless lattice_frictionless box_smooth wall_smooth", "friction", "friction belongs to the material: define one without friction, `material smooth density 2650 kg/m3 kn 10 MN/m ks 10 MN/m friction 0`, and write `smooth` here"},
    {"set_random set_seed", "seed", "each `fill` has its own seed of random numbers: `seed 1`"},
    {"set_fric set_friction", "friction", "friction is changed by `material NAME friction 0.5`"},
    {"ball_fix", "fixed", "a particle that does not move is `disc X Y radius R MATERIAL fixed`"},
    {"fix_NUMBER fix_wall/gran fix_nve/sphere", "wall, gravity, fixed", "motion is integrated without a statement; a wall is `wall floor -1 m 0 m to 1 m 0 m MATERIAL`, gravity is `gravity 0 m/s2 -9.81 m/s2`"},
    {"stage_velocity", "velocity, zero velocities", "a stage gives no velocity to a particle: `disc 0 m 0 m radius 5 mm MATERIAL velocity 1 m/s 0 m/s` in the scene does, `zero velocities` in a stage stops all particles, and a wall moves by `wall NAME velocity 0 m/s -1 mm/s`"},
    {"wall_tilt wall_tilted wall_angle wall_inclined wall_inclination wall_slope wall_rotate wall_rotation wall_deg stage_tilt scene_tilt scene_incline", "wall, gravity", "a wall is given by its two ends: at 20 deg to x it is `wall ramp 0 m 0 m to (cos(20 deg)*1 m) (sin(20 deg)*1 m) MATERIAL`. In a stage it rotates by `wall NAME spin 0.1 rad/s`, or gravity is inclined: `gravity (9.81 m/s2*sin(20 deg)) (-9.81 m/s2*cos(20 deg))`"},
    {"scene_velocity", "disc, sphere", "an initial velocity is a part of a particle: `disc 0 m 0 m radius 5 mm MATERIAL velocity 1 m/s 0 m/s`"},
    {"compute", "record", "write `record time energy.kinetic`; `nineball --help quantities` lists the quantities"},
    {"PWaveTimeStep GlobalStiffnessTimeStepper", "stable", "write `step 0.3 of stable`, with elastic spheres `step 0.2 of rayleigh`"},
    {"boundary_p boundary_f boundary_s boundary_periodic", "cell, box", "periodic boundaries are `periodic cell 0 m 0 m to 1 m 1 m`, walls are `box 0 m 0 m to 1 m 1 m MATERIAL`"},
    {"contact_test_hold", "segment", "`hold` is a clause of a segment: `segment slide slip to 2 um hold normal in 1000 steps` keeps the normal force"},
    {"contact_test_damping contact_test_dashpot contact_test_dashpots contact_test_viscosity contact_test_restitution", "normal, shear, damping", "delete this line: a contact test has no velocities, so it has no dashpots; in a block `scene` they are `damping ratio 0.2`"},
    {"contact_test_variant contact_test_variants contact_test_case contact_test_cases", "sweep", "a run for each of several values is a sweep: `sweep mu 0.1 0.3` and `friction $mu` in a `material`; a law is swept likewise, by `sweep law linear hertz` and `$law` after `normal`"},
    {"contact_test_step", "segment", "a contact test has no time; a segment has its number of steps: `segment load normal to 100 N in 100 steps`"},
    /* expect_WORD: a word in any place of an expectation */
    {"expect_trend expect_proportional expect_scales expect_scaling expect_power expect_exponent expect_monotonic expect_monotonically expect_varies expect_depends expect_correlates", "increases, decreases", "a trend with a sweep is `A.vx max  increases with k`, or `decreases with k`"},
    {"expect_approx expect_approximately expect_about expect_~ expect_= expect_== expect_equals expect_equal", "expected", "write `C.normal max  expected 3 N within 1 % [SOURCE]`"},
    {"expect_plot expect_curve expect_figure expect_draw expect_graph", "gnuplot", "a curve is drawn by a block `gnuplot` with the line `plot $table using 'time/s':'C.normal/N' with lines`, and with a sweep `plot for [i=1:runs] sprintf('$table_%d', i) using 'time/s':'C.normal/N' with lines`"},
    {"vs against", "versus"},
    {"expect_finally", "last", "the last row is `last`, which is the default: `C.normal last  below 2 N`"},
    {"expect_average expect_avg", "mean", "the mean of the rows is `mean`: `C.normal mean in load  below 3 N`"},
    {"expect_always expect_every expect_everywhere expect_never expect_each expect_throughout", "min, max", "to check all rows of a stage write `A.vx min in STAGE  above -1 m/s` and `A.vx max in STAGE  below 3 m/s`; a value at one time is `A.vx at 0.1 s  expected 3 m/s within 1 % [SOURCE]`"},
    {"expect_first expect_initial expect_begin expect_start", "expected", "the first row of the run is `at 0 cycles`. The first row of a later stage, or after `start`, is `at N cycles`: `record cycle` and `report cycle min in STAGE` show N; `nineball --help expect` lists all such words"},
    {"expect_positive expect_negative expect_zero expect_nonzero expect_!=", "above, below", "write `above 0 N` or `below 0 N`, with the unit of the quantity; a value of zero is `expected 0 N within 1 mN [SOURCE]`"},
    {"expect_rms expect_sum", "max, min, mean", "there is no such word; `nineball --help expect` lists the words that may follow a quantity"},
    {"expect_std expect_stddev expect_std_dev expect_variance expect_sd expect_standard expect_standard_deviation", "amplitude", "the rows have no standard deviation: `amplitude` is half the difference between the largest and the smallest value, `C.normal amplitude in load  below 1 N`; the standard deviation over the contacts of a region is a quantity, `M.normal.std`"},
    {"expect_range expect_peak_to_peak expect_spread", "amplitude, above, below", "the largest value minus the smallest one is twice the amplitude, `C.normal amplitude in STAGE  below 1 N`; for a range of values write two lines, one with `above` and one with `below`"},
    {"expect_conserved expect_unchanged expect_drift expect_drifts expect_steady expect_stationary", "amplitude, constant", "to check that a quantity is constant in time, write `momentum.x amplitude in all  expected 0 kg.m/s within 1e-9 kg.m/s [SOURCE]`"},
    {"expect_integral quantity_integral integral integrate trapz quantity_work quantity_work.walls quantity_walls.work quantity_work.wall quantity_energy.work quantity_work.done quantity_work.external quantity_energy.external", "energy.walls", "there is no integral over rows. The work of moving walls and moving fixed particles is `energy.walls`, that of gravity `energy.gravity`, the energy dissipated by friction `energy.friction`: `record energy.walls`"},
    {"expect_slope expect_rate expect_derivative expect_gradient quantity_slope quantity_rate quantity_derivative slope derivative", "at, expected", "there is no slope or rate of change: compare the values at two times, `A.vx at 2 ms  expected 2 of A.vx at 1 ms within 1 % [SOURCE]`, or a value with a formula, `A.vx at 2 ms  expected (a*2 ms) within 1 % [SOURCE]`, with `let a = 3 m/s2` in the scene. The elastic moduli of a packing, upper bounds, are `M.modulus.bulk` and `M.modulus.shear`, with `region M all`"},
    {"expect_minus expect_change expect_difference expect_diff expect_increment expect_gain expect_rise expect_growth", "expected", "a line has no difference of two measures: write `A.vx last  expected (v + 3 m/s) within 1 % [SOURCE]`, with `let v = 1 m/s` in the scene, or `A.vx last  expected 2 of A.vx at 0 cycles within 1 % [SOURCE]`"},
    {"expect_after expect_before expect_during expect_when expect_once", "in", "the name of a stage follows `in`: `A.vx last in bounce  expected -0.7 of A.vx last in approach within 1 % [SOURCE]`"},
    {"expect_order", "order", "the measure comes first, and the swept value is named: `energy.balance max in all  order 2 in dt within 0.1`, with `sweep dt 1 us 2 us 4 us` and `step $dt` in the scene. The order of another quantity is that of its error against a line `reference NAME`, not against a value after `expected`"},
    {"expect_expect expect_check expect_require expect_verify expect_test expect_claim expect_assert", "expected", "the line begins with the quantity: `C.normal max  expected 3 N within 1 % [SOURCE]`"},
    {"expect_+_ expect_±", "within", "a tolerance is `within 1 %`, or a number with its unit, `within 0.1 N`"},
    {"expect_let", "let", "`let` belongs in the scene: a formula of an expectation uses the names that the scene defines by `let a = 1`"},
    {"expect_print", "report", "write `report energy.kinetic max in STAGE`"},
    {"expect_stage", "in", "`in` is followed by the name alone: `C.normal max in load`"},
    {"expect_expected", "expected", "the value follows the quantity, a reducer and `in STAGE`: `C.shear last in load  expected 0.1 N within 1 % [SOURCE]`, or at a time `C.shear at 2 ms  expected 0.1 N within 1 % [SOURCE]`, or, for a value in another stage, `expected 1 of C.shear last in unload within 1 % [SOURCE]`"},
    {"expect_period", "frequency", "the period is 1 over the `frequency`, which needs the values of a whole stage: for a period of 0.2 s write `A.x frequency in load  expected 5 1/s within 1 % [SOURCE]`"},
    {"expect_abs expect_magnitude expect_absolute expect_mag expect_norm expect_absmax", "above, below", "a magnitude below X is two lines: `C.shear max below X` and `C.shear min above -X`"},
    /* quantity_WORD: another name of a quantity */
    {"quantity_friction_energy quantity_frictional_energy quantity_friction_work quantity_friction_dissipation quantity_friction_loss quantity_energy.slip quantity_energy.slipped quantity_eslip", "energy.friction"},
    /* whole_WORD: a name without an owner, or after that of a region; its parts have other meanings */
    {"whole_displacement whole_displacements whole_disp whole_displacement.mean whole_mean_displacement whole_displacement.max whole_max_displacement whole_average_displacement whole_displacement_magnitude whole_displacement.total whole_total_displacement", "snapshot", "the displacements of all particles since STAGE are written by `snapshot from STAGE`, a line in a stage, at its end, to the file of particles; those of one particle follow from `record A.x A.y` with `monitor A disc 1`"},
    {"whole_height whole_heights whole_height.max whole_max_height whole_maximum_height whole_sample.height whole_height.sample whole_deposit.height whole_height.deposit whole_bed_height whole_packing_height whole_pile_height whole_surface_height whole_fill_height whole_top whole_ymax whole_y.max whole_max_y", "snapshot", "the height of a deposit is no quantity: a stage with the line `snapshot` writes all particles at its end, and the height is the largest `y/m` there plus the radius. `box.height` is the distance of two walls"},
    {"whole_impacts whole_impact_count whole_impacts.count whole_number_of_impacts whole_impact_number whole_bounces whole_bounce_count whole_number_of_bounces whole_collisions whole_collision_count whole_number_of_collisions", "until", "impacts are not counted: let each one end a stage, `until C.overlap above 0 m at most 1000000 cycles`, with `monitor C sphere 1 with wall NAME`, and the next stage end with `until C.overlap below 1e-12 m at most 1000000 cycles`"},
    {"whole_sliding.share whole_sliding.fraction whole_sliding_fraction whole_fraction_sliding whole_fraction_of_sliding_contacts", "sliding", "the sliding fraction is `M.sliding`, with `region M all`; `M.sliding.near` counts contacts near their limit, too"},
    {"whole_rattlers.share whole_rattlers.fraction whole_rattlers.ratio whole_rattler_fraction whole_rattlers_fraction whole_fraction_of_rattlers whole_rattler_share", "rattlers, particles", "`rattlers` is a number; its fraction is an expectation, `M.rattlers last  expected 0.2 of M.particles last within 0.01 [SOURCE]`, with `region M all` and `record M.rattlers M.particles`"},
    {"whole_energy whole_sum_energy whole_energy_sum", "energy.kinetic, energy.stored, energy.balance", "the total energy is the sum `energy.kinetic` plus `energy.stored`, less the work of gravity: `record energy.kinetic energy.stored energy.gravity`. The error of the energy balance is `energy.balance`"},
    {"quantity_weight weight expect_weight whole_weight whole_total_weight whole_weight_total whole_mass whole_total_mass whole_weight_of_all", "expected", WEIGHT},
    {"whole_time_of_max whole_time_of_maximum whole_time_of_peak whole_time_max whole_max_time whole_peak_time whole_arrival_time whole_arrival whole_time_of_arrival whole_argmax expect_time_of_max expect_time_of_maximum expect_time_of_peak expect_argmax expect_peak_time", "until", "there is no time of a maximum: let the event end a stage, `until C.normal above 1 N at most 1000000 cycles`, and with `record time` check `time last in STAGE  above 0 s`"},
    {"whole_porosity", "box.porosity, porosity", "in a box take `box.porosity`, the porosity between its walls; in a cell or without walls `region M all`, then `M.porosity`. `M.porosity.volume` is by volume and differs for spheres"},
    {"stress_direction whole_stress_direction whole_stress_principal_direction whole_principal_direction whole_principal_stress_direction whole_principal_angle whole_principal_axis whole_direction_of_stress principal_direction principal_angle principal_axis", "stress.angle", "the direction of the major principal stress is `M.stress.angle`, in rad from x, with `region M all`"},
    {"whole_fabric_direction whole_fabric_principal_direction whole_direction_of_fabric fabric_direction", "fabric.angle", "the major principal direction of the fabric tensor is `M.fabric.angle`, in rad from x, with `region M all`"},
    {"whole_fabric_deviator whole_fabric_deviatoric whole_fabric_q whole_deviator_of_fabric whole_deviatoric_fabric fabric_deviator", "fabric.anisotropy", "the major minus the minor principal value of the fabric tensor is `M.fabric.anisotropy`, with `region M all`"},
    {"whole_mean_x whole_mean_y whole_max_x whole_min_x whole_min_y whole_x_mean whole_y_mean whole_x_max whole_x_min whole_y_min whole_average_x whole_average_y whole_centroid whole_centroid_x whole_centroid_y whole_xmax whole_xmin whole_ymin", "snapshot", "there is no mean, maximum or minimum of the positions of all particles: a stage with the line `snapshot` writes `x/m` and `y/m` of all particles at its end. The position of one particle is `monitor A disc 1`, then `record A.x A.y`"},
    {"whole_slope_angle whole_angle_of_repose whole_repose_angle whole_repose whole_heap_angle whole_slope_of_heap slope_angle angle_of angle_of_repose repose_angle", "snapshot", "there is no quantity for the slope of a heap: a stage with the line `snapshot` writes the positions of all particles at its end"},
    /* of_KIND_WORD: a word after the name of a monitor of this kind, which has no such quantity */
    {"of_wall_vx of_wall_vy of_wall_v of_wall_velocity of_wall_speed of_wall_velocity_x of_wall_velocity_y of_wall_xvel of_wall_yvel", "wall", "the velocity of a wall is no quantity: a stage prescribes it, for example by `wall NAME velocity VX VY`, `box strain` or `servo`. With `monitor F wall NAME` a wall has `F.x`, `F.y`, `F.angle`, `F.spin`, `F.fx`, `F.fy` and `F.moment`"},
    {"of_contact_moment of_contact_torque of_contact_rolling of_contact_bending of_contact_rolling_moment", "moment", "a contact transmits no moment; `A.moment`, with `monitor A disc 1`, is the moment of the forces on a particle"},
    {"whole_contacts_by_material", "snapshot", "contacts are not counted by material: a stage with the line `snapshot` writes each contact at its end, with the numbers of its two particles; `M.coordination` and `contacts` count all"},
    {"quantity_p quantity_pressure quantity_mean_stress quantity_s quantity_pprime", "stress.mean"}, {"quantity_q quantity_deviatoric_stress quantity_deviator quantity_deviator_stress quantity_deviatoric", "stress.deviator"},
    {"quantity_cell.stress.ratio quantity_box.stress.ratio quantity_walls.stress.ratio quantity_cell.stress_ratio quantity_box.stress_ratio quantity_friction-angle quantity_friction_angle quantity_friction.angle quantity_friction quantity_stress.friction quantity_stress.ratio quantity_stress_ratio quantity_stressratio quantity_eta quantity_stress.eta quantity_mobilized_friction quantity_mobilised_friction quantity_mobilised_friction_angle quantity_mobilized_friction_angle", "stress.sinphi", "`stress.sinphi` is the deviator over twice the mean stress, the sine of the mobilized friction angle: `region M all`, then `record M.stress.sinphi`. In a box `record walls.ratio` is the normal force on `east` and `west` over that on `south` and `north`. In simple shear the shear stress over the normal stress follows from `record cell.stress.xy cell.stress.yy`"},
    {"quantity_t", "time, stage.time"}, {"quantity_cycles quantity_ncycles", "cycle"}, {"quantity_stress.q quantity_stress.t", "stress.deviator"}, {"quantity_stress.p quantity_stress.s", "stress.mean"},
    {"quantity_floaters quantity_floater", "rattlers"}, {"quantity_force_chains quantity_force_chain quantity_chain", "chains"}, {"quantity_timestep quantity_time_step quantity_dt quantity_step_size", "step"},
    {"quantity_overlap_max quantity_max_overlap quantity_maximum_overlap quantity_overlap_maximum quantity_largest_overlap quantity_contacts_overlap_max quantity_gap quantity_gap_min quantity_min_gap", "gap, overlap", "`gap` is the smallest gap between two particles, and below 0 m its magnitude is the largest overlap: `record gap`. The overlap of one contact is `C.overlap`, with `monitor C disc 1 with disc 2`, and its largest value is `C.overlap max` in a block `expect`"},
    /* suffix_PART: the last part of the name of a quantity */
    {"suffix_1 suffix_I", "major"}, {"suffix_2 suffix_3 suffix_II suffix_III", "minor"}, {"suffix_11", "xx"}, {"suffix_12", "xy"}, {"suffix_21", "yx"}, {"suffix_22", "yy"},
    {"suffix_zz suffix_33 suffix_xz suffix_yz", "xx, yy", "the simulation is in the plane, x to the right and y up, and no quantity has a component in z: write `xx`, `xy`, `yx` or `yy`"},
    {"quantity_e", "void_ratio"}, {"quantity_n quantity_poros quantity_phi", "porosity"}, {"quantity_z quantity_cn", "coordination"},
    {"quantity_sxx quantity_s11 quantity_sigma_xx quantity_sigmaxx quantity_sigma_h quantity_pxx", "stress.xx"}, {"quantity_syy quantity_s22 quantity_sigma_yy quantity_sigmayy quantity_sigma_v quantity_sigma quantity_pyy", "stress.yy"}, {"quantity_sxy quantity_s12 quantity_tau quantity_sigma_xy quantity_pxy", "stress.xy"},
    {"quantity_exx quantity_eps_xx quantity_epsxx quantity_e11 quantity_epsilon_xx", "strain.xx"}, {"quantity_eyy quantity_eps_yy quantity_epsyy quantity_e22 quantity_epsilon_yy quantity_ea quantity_epsilon quantity_eps", "strain.yy"}, {"quantity_ev quantity_volumetric_strain quantity_vol_strain quantity_volume_strain quantity_eps_v quantity_eps_vol quantity_epsv quantity_epsilon_v", "strain.volumetric"},
    {"quantity_fn quantity_f_n quantity_nforce quantity_normal_force quantity_normalforce quantity_fnormal", "normal, normal.mean"}, {"quantity_fs quantity_ft quantity_f_s quantity_f_t quantity_sforce quantity_shear_force quantity_tangential_force quantity_shearforce quantity_fshear", "shear, shear.mean"},
    {"quantity_un quantity_u_n quantity_delta quantity_delta_n quantity_alpha quantity_penetration quantity_penetrationdepth quantity_indentation", "overlap"}, {"quantity_ut quantity_u_t quantity_us quantity_delta_t", "slip"},
    {"quantity_spin.after quantity_impact.spin quantity_impact.spin2 quantity_impact.omega quantity_impact.omega2 quantity_impact.spin_after quantity_impact.vx quantity_impact.vy quantity_impact.velocity quantity_impact.v quantity_impact.v2 quantity_impact.vt quantity_impact.vn quantity_impact.speed", "spin, vx, vy", "an impact has no velocities and no spin; those of the particle are recorded with `monitor A sphere 1` and `record A.vx A.vy A.spin`"},
    {"quantity_w quantity_omega quantity_wz quantity_omegaz quantity_omega_z quantity_angvel quantity_angular_velocity quantity_rotvel quantity_angular", "spin"}, {"quantity_theta quantity_rot quantity_rotation", "angle"},
    {"quantity_ax quantity_ay quantity_acc quantity_accel quantity_acceleration quantity_xacc quantity_yacc quantity_acc_x quantity_acc_y", "expected", "there is no quantity for the acceleration: compare the velocity with a formula, `A.vx at 2 ms  expected (v + a*2 ms) within 1 % [SOURCE]`, with `let v = 1 m/s` and `let a = 3 m/s2` in the scene; mass times acceleration is the contact force, `A.fx` and `A.fy`, plus the weight"},
    {"quantity_vn quantity_v_n quantity_vt quantity_v_t quantity_vs quantity_vrel quantity_v_rel quantity_velocity_normal quantity_normal_velocity quantity_relative_velocity quantity_approach_velocity quantity_overlap_rate quantity_overlap.rate", "monitor, vx, vy", "a contact has no relative velocity: record those of its particles with `monitor A disc 1`, `monitor B disc 2` and `record A.vx B.vx`; their difference is plotted by `column('A.vx/m/s') - column('B.vx/m/s')`, and a restitution is `A.vx last in touch  expected -0.7 of A.vx last in approach within 1 % [SOURCE]`"},
    {"quantity_rebound quantity_rebound_angle quantity_rebound.angle quantity_angle.rebound quantity_velocity.angle quantity_velocity_angle quantity_v.angle quantity_direction quantity_velocity.direction quantity_heading quantity_angle.after quantity_angle_after quantity_exit_angle quantity_angle.out quantity_angle_out quantity_reflection_angle quantity_outgoing_angle quantity_impact.rebound quantity_impact.angle.rebound quantity_impact.angle2 quantity_impact.rebound_angle quantity_impact.angle.after", "vx, vy", "no quantity is the direction of a velocity, and `A.angle` is a rotation: record `A.vx` and `A.vy`; for a velocity at 20 degrees, pi/9, from the y axis write `A.vx last  expected (tan(pi/9)) of A.vy last within 1 % [SOURCE]`"},
    {"quantity_v", "vx, vy"}, {"quantity_xvel", "vx"}, {"quantity_yvel", "vy"}, {"quantity_xfob quantity_xfor", "fx"}, {"quantity_yfob quantity_yfor", "fy"}, {"quantity_torque quantity_tz", "moment"},
    {"quantity_box.strain quantity_box.strain.xx quantity_box.strain.yy quantity_box.strain.x quantity_box.strain.y quantity_box.exx quantity_box.eyy quantity_box.axial_strain quantity_box.strain.axial", "box.strain.width, box.strain.height", "the strains of a box are those of its width, in x, and of its height, in y: `record box.strain.width box.strain.height`, relative changes since time 0, extension positive. Those of a region, `M.strain.xx` and `M.strain.yy` with `region M all`, follow from the motion of its particles"},
    {"quantity_box.servo quantity_box.servo.xx quantity_box.servo.yy quantity_walls.servo.xx quantity_walls.servo.yy quantity_servo.xx quantity_servo.yy quantity_servo.stress quantity_servo.stress.xx quantity_servo.stress.yy", "box.stress.xx, walls.stress.xx", "a servo has no quantity of its own. With `on box` it controls `box.stress.xx` and `box.stress.yy`, with `on walls` `walls.stress.xx` and `walls.stress.yy`: `record box.stress.xx box.stress.yy`"},
    {"quantity_cell.shear quantity_cell.gamma quantity_cell.c12 quantity_cell.shear_strain quantity_cell.strain.shear quantity_cell.shear.strain", "cell.xy, cell.strain.xy", "the engineering shear strain of a cell is `cell.xy` over `cell.yy`: `record cell.xy cell.yy`, then `cell.xy  expected 0.1 of cell.yy within 1 % [SOURCE]`. `cell.strain.xy` is half of it in a cell that only shears"},
    {"reset_strain reset_strains reset_displacement reset_displacements reset_cell reset_box reset_region reset_cell.strain reset_cell.strain.xx reset_cell.strain.yy reset_cell.strain.xy reset_cell.strain.volumetric reset_box.strain reset_box.strain.width reset_box.strain.height zero_strain zero_strains zero_displacement zero_displacements zero_cell zero_box zero_region zero_cell.strain zero_cell.strain.xx zero_cell.strain.yy zero_cell.strain.xy zero_cell.strain.volumetric zero_box.strain zero_box.strain.width zero_box.strain.height reset", "region", "no strain is set to zero: strains count from the start of the run. With `region S all from STAGE` the strain `S.strain.yy` counts from the beginning of STAGE, for `record` and `until`; the sides of a cell or a box are compared by `cell.yy last in LATER  expected 0.98 of cell.yy last in EARLIER within 1 % [SOURCE]`, `box.height` likewise"},
    {"reset_energy reset_energies reset_work reset_dissipation zero_energy zero_energies zero_work zero_dissipation", "expected", "no energy is set to zero: energies count from the start of the run. Two stages are compared by `energy.friction last in LATER  expected 2 of energy.friction last in EARLIER within 1 % [SOURCE]`"},
    {"quantity_stage.strain quantity_stage.strain.xx quantity_stage.strain.xy quantity_stage.strain.yy quantity_stage.strain.volumetric", "region", "a strain since a stage is that of a region: `region S all from STAGE`, then `record S.strain.xx S.strain.xy S.strain.yy S.strain.volumetric`"},
    {"quantity_box.strain.volumetric quantity_box.strain.volume quantity_box.strain.area quantity_box.strain.mean quantity_box.volumetric", "box.width, box.height", "the volumetric strain of a box is the relative change of its area, `box.width` times `box.height`: `record box.width box.height`. That of a region is `M.strain.volumetric`, with `region M all`; it follows from the motion of its particles and differs"},
    {"quantity_velocity.fluctuation quantity_velocity_fluctuation quantity_fluctuation quantity_granular_temperature quantity_speed.rms quantity_velocity.rms quantity_speed.fluctuation", "speed.mean", "the fluctuation of velocities is `M.speed.mean`, with `region M all`: the mean speed relative to the imposed motion, m/s"},
    {"quantity_boundary_work quantity_work.boundary quantity_boundary.work", "energy.walls, energy.imposed", "the work of walls is `energy.walls`, that of a strained cell or a boundary of particles `energy.imposed`: `record energy.walls energy.imposed`"},
    {"quantity_rebound_height quantity_rebound.height quantity_bounce_height quantity_height_of_rebound", "until", "the height of a rebound is the largest `A.y` after it, with `monitor A disc 1` and `record A.y`: one stage ends with the contact, `until C.overlap below 1e-12 m at most 1000000 cycles`, the next one at the top, `until A.vy below 0 m/s at most 1000000 cycles`, and `report A.y max in STAGE` has its height"},
    {"drop drop_height quantity_drop_height quantity_drop quantity_fall_height", "disc, sphere", "a drop begins with a particle above a wall: `wall floor -1 m 0 m to 1 m 0 m MATERIAL`, `disc 0 m 0.5 m radius 5 mm MATERIAL` and `gravity 0 m/s2 -9.81 m/s2`. Its height is the y of the centre less the radius"},
    {"impact_angle quantity_impact_angle quantity_angle_of_impact quantity_incidence_angle quantity_angle_of_incidence", "impact", "the angle of incidence is given, with `monitor C disc 1 with disc 2`, by `impact C speed 1 m/s angle 20 deg` in the scene"},
    {"quantity_incline_angle quantity_inclination quantity_angle_of_incline", "gravity", "a slope is given by gravity: `gravity (9.81 m/s2*sin(20 deg)) (-9.81 m/s2*cos(20 deg))`"},
    {"quantity_damping_ratio quantity_damping", "damping", "a damping ratio is given, not computed: `damping ratio 0.2`; the energy that it dissipates is `energy.damped`"},
    {"quantity_young quantity_youngs_modulus quantity_young's_modulus quantity_young_modulus quantity_poisson quantity_poisson_ratio quantity_poissons_ratio quantity_poisson's_ratio quantity_stiffness", "modulus.bulk, modulus.shear", "`young` and `poisson` are properties of a `material`; the elastic moduli of a packing, upper bounds, are `M.modulus.bulk` and `M.modulus.shear`, with `region M all`"},
    {"quantity_Zm quantity_zm quantity_z_m", "coordination.mechanical"},
    {"quantity_wall_force quantity_wall_forces quantity_force_on_wall quantity_wall_reaction", "fx, fy", "the force of the particles on a wall is `F.fx` and `F.fy`, with `monitor F wall NAME`"},
    {"quantity_fabric_tensor", "fabric.xx", "the fabric tensor of a region has the components `M.fabric.xx`, `M.fabric.xy`, `M.fabric.yx` and `M.fabric.yy`, with `region M all`; its anisotropy is `M.fabric.anisotropy`"},
    {"of_contact_tangential_displacement of_contact_shear_displacement of_contact_displacement of_contact_us of_contact_ut", "sliding", "in a scene a contact has no tangential displacement: `C.sliding` is 1 while the contact slides; with `impact` it is `impact.slip`, and in a contact test `slip`"},
    {"of_contact_mobilised_friction of_contact_mobilized_friction of_contact_mobilisation of_contact_mobilization of_contact_friction of_contact_obliquity", "sliding", "the mobilized friction of a contact is its shear force over its limit, friction times normal force: `record C.shear C.normal`; `C.sliding` is 1 at the limit"},
    {"of_particle_position of_particle_positions of_particle_pos", "x, y", "the position of a particle is `A.x` and `A.y`, with `monitor A disc 1`"},
    {"of_particle_kinetic_energy of_particle_energy of_particle_ke of_particle_energy.kinetic", "energy.kinetic", "the energy of one particle is no quantity: it follows from `record A.vx A.vy A.spin`; `energy.kinetic` is that of all free particles"},
    {"of_wall_normal_force of_wall_shear_force of_wall_contact_force of_wall_tangential_force of_wall_reaction", "fx, fy", "the force of the particles on a wall has the components `F.fx` and `F.fy`, with `monitor F wall NAME`"},
    {"of_wall_stress of_wall_pressure of_wall_stress.xx of_wall_stress.yy of_wall_normal_stress", "walls.stress.xx, walls.stress.yy", "the mean normal stresses on the walls of a box are `walls.stress.xx` and `walls.stress.yy`; that on one wall is its force, `F.fx` or `F.fy`, over its length and 1 m"},
    {"quantity_inertial_number quantity_inertial.number quantity_inertia_number quantity_I", "cell.stress.mean", "there is no quantity for the inertial number: it is d g sqrt(rho/p), with the diameter d, the shear rate g, the density rho and the mean stress p, `cell.stress.mean` or `box.stress.mean`"},
    {"quantity_dilatancy quantity_dilation quantity_dilatancy_angle quantity_dilation_angle quantity_psi", "strain.volumetric", "dilatancy is the volumetric strain, expansion positive, against the shear strain: `record cell.strain.volumetric cell.strain.xy` in a cell; without a cell `record M.strain.volumetric M.strain.deviator` with `region M all`, a fit to the displacements of the particles. There is no quantity for a dilatancy angle"},
    {"quantity_hysteresis quantity_hysteresis_loop quantity_energy.hysteresis", "energy.friction", "the energy that a loop dissipates is `energy.friction`, by friction, plus `energy.damped`, by damping; a loop is drawn by `plot $table using 'M.strain.yy/-':'M.stress.yy/Pa' with lines` in a block `gnuplot`"},
    {"quantity_pe quantity_etotal quantity_pe_ke", "energy.balance", "`energy.gravity` is the work of gravity since the start, the negative change of the potential energy; the error of the energy balance is `energy.balance`"},
    {"quantity_box.area quantity_box.volume quantity_volume", "box.width, box.height", "the area of a box is `box.width` times `box.height`: `record box.width box.height`; that of a region is `M.area`, with `region M all`"},
    {"quantity_cell.area quantity_cell.volume", "cell.strain.volumetric, cell.xx, cell.yy", "the area of a cell is `cell.xx` times `cell.yy`, minus `cell.xy` times `cell.yx`; its relative change is `cell.strain.volumetric`: `record cell.strain.volumetric`"},
    {"quantity_slip quantity_C.slip", "sliding, impact.slip", "in a scene a contact has no slip: `C.sliding` is 1 while the contact slides; with `impact` it is `impact.slip`, and in a contact test `slip`"},
    {"quantity_restitution quantity_cor quantity_coefficient_of_restitution", "impact.restitution", "a restitution is a ratio of velocities: with `monitor A sphere 1` and `record A.vx` write `A.vx last in touch  expected -0.7 of A.vx last in approach within 1 % [SOURCE]`; in a scene with `impact` it is `impact.restitution`"},
    {"quantity_overlap.mean quantity_mean.overlap quantity_mean_overlap quantity_overlaps quantity_contacts.overlap quantity_contacts.overlap.mean quantity_contact.overlap.mean", "normal.mean, contacts.deep", "there is no mean overlap: with `normal linear` it is the mean normal force over the stiffness, `M.normal.mean` over `kn`, with `region M all`"},
    {"quantity_unbalanced.max quantity_unbalanced.mean", "unbalanced.max, unbalanced.mean", "`unbalanced.max` is a quantity of the whole scene: the largest unbalanced force over the largest contact force; `M.unbalanced.mean`, with `region M all`, is the ratio of the means"},
    {"quantity_box.pressure quantity_box.p quantity_box.mean_stress", "box.stress.mean", "the mean stress of a box is `box.stress.mean`"},
    {"quantity_rose quantity_rose_diagram quantity_orientation quantity_contact_orientation quantity_contacts.rose quantity_contacts.orientation quantity_fabric.rose rose", "snapshot, fabric", "a rose diagram is drawn from a line `snapshot` in the stage by a block `gnuplot` with the lines `contacts = '$STAGE_contacts'; weight = 'all'` and `load plots.'polar-normals.gp'`; the fabric tensor is `M.fabric.xx`, with `region M all`"},
    {"quantity_histogram histogram hist_contacts stage_histogram scene_histogram distribution_contacts", "snapshot", "a histogram is drawn from a line `snapshot` in the stage by a block `gnuplot` with the lines `tables = '$STAGE_contacts'; names = 'forces'`, `stats $STAGE_contacts using 'normal/N' name 'f' nooutput`, `of(c) = column('normal/N')/f_mean; low = 0; high = 5; bins = 20; curve(v) = NaN` and `load plots.'histogram.gp'`"},
    {"quantity_impulse quantity_impulse.shear quantity_impulse.normal quantity_shear.impulse quantity_normal.impulse", "mean", "there is no quantity for an impulse: it is the mean force times the duration, `C.shear mean in touch`, or follows from the change of `A.vx` or `A.spin`"},
    {"expect_duration quantity_duration quantity_contact_time quantity_collision_time quantity_impact_time quantity_contact_duration", "impact.duration, stage.time", "with one impact write `impact C speed 1 m/s angle 0 deg` in the scene, then `record impact.duration`. The duration of another contact is that of a stage, to within one time step: end one stage with `until C.overlap above 0 m at most 1000000 cycles`, the next one, `stage touch`, with `until C.overlap below 1e-12 m at most 1000000 cycles`, and write `record stage.time` and `report stage.time in touch`"},
    {"until_contact until_contacts until_no until_separation until_separated until_separate until_contact_lost until_lost_contact until_detached until_touch until_touching", "until", "to end a stage at the end of a contact, write `until C.overlap below 1e-12 m at most 1000000 cycles` in a stage that begins during the contact, with `monitor C disc 1 with disc 2` in the scene; to end a stage at the first cycle of the contact, write `until C.overlap above 0 m at most 1000000 cycles`"},
    {"quantity_shear_modulus", "modulus.shear", "the shear modulus of a packing, an upper bound, is `M.modulus.shear`, with `region M all`; the bulk modulus is `M.modulus.bulk`"},
    {"box_open box_without box_no box_top box_lid box_except box_bottom box_walls box_sides", "wall", THREE_WALLS},
    {"box_shear box_c12 box_c21", "cell strain, boundary strain", "`box strain` does not rotate the walls, so it has no shear"},
  };
  /* clang-format on */
  char plain[NB_NAME_SIZE];
  const size_t length = (size_t)snprintf(plain, sizeof plain, "%.*s", (int)strcspn(word, "("), word); /* `O.run(9)` */
  if (length == 0 || length >= sizeof plain)
    return NULL;      /* no synonym is so long */
  bool loose = false; /* a loose spelling is in the table; if not, no exact one is */
  for (size_t k = 0; k < sizeof synonyms / sizeof *synonyms && !loose; k++)
    loose = has_word(synonyms[k].words, plain, length, true);
  for (enum spelling spelling = loose ? EXACT : SINGULAR; spelling <= SINGULAR; spelling++) {
    const char *const last = strrchr(plain, '_'); /* `expect_rises` has no other meaning than `rises` */
    if (spelling == SINGULAR && (length < 4 || plain[length - 1] != 's' || (last && nb_synonym(last + 1))))
      break;
    const size_t n = length - (spelling == SINGULAR);
    plain[n] = '\0';
    for (size_t k = 0; k < sizeof synonyms / sizeof *synonyms; k++)
      if (has_word(synonyms[k].words, plain, n, spelling != EXACT))
        return &synonyms[k];
  }
  return NULL;
}

/* Lists the marked words of the page language: "`fill`, `disc` or `sphere`". */
static void list_ours(char list[NB_HINT_SIZE / 2], const struct nb_synonym *synonym, unsigned marked) {
  char item[NB_NAME_SIZE];
  list[0] = '\0';
  for (const char *at = synonym->ours; nb_item(&at, item); marked >>= 1)
    if (marked & 1)
      nb_append_item(list, NB_HINT_SIZE / 2, item, !(marked > 1 && *at));
}

const char *nb_synonym_hint(char *hint, const char *word) {
  const struct nb_synonym *const synonym = nb_synonym(word);
  char list[NB_HINT_SIZE / 2];
  if (!synonym)
    return NULL;
  list_ours(list, synonym, ~0u);
  if (synonym->note && strstr(synonym->note, "--help"))
    snprintf(hint, NB_HINT_SIZE, "%s", synonym->note);
  else if (synonym->note)
    snprintf(hint, NB_HINT_SIZE, "%s; see `nineball --help %.*s`", synonym->note, (int)strcspn(synonym->ours, ","),
             synonym->ours);
  else
    snprintf(hint, NB_HINT_SIZE, "`%.80s` of other programs is %s here: see `nineball --help %.80s`", word, list, word);
  return hint;
}

/* Joins two words as in `synonyms`; a number as the second word becomes NUMBER. */
static const char *pair_of(char pair[2 * NB_NAME_SIZE], const char *first, const char *second) {
  snprintf(pair, 2 * NB_NAME_SIZE, "%.63s_%.63s", first, isdigit((unsigned char)*second) ? "NUMBER" : second);
  return pair;
}

const struct nb_synonym *nb_pair_synonym(const char *first, const char *second) {
  char pair[2 * NB_NAME_SIZE];
  return nb_synonym(pair_of(pair, first, second));
}

const char *nb_pair_hint(char *hint, const char *first, const char *second) {
  char pair[2 * NB_NAME_SIZE];
  return nb_synonym_hint(hint, pair_of(pair, first, second));
}

/* ---- the nearest word ---- */

/* Number of insertions, deletions, changes and swaps of neighbouring letters between a and b (optimal string alignment
 * distance), upper and lower case being equal. */
static int distance(const char *a, const char *b) {
  enum { LONGEST = 2 * NB_NAME_SIZE };
  int row[3][LONGEST + 1];
  size_t m = strlen(a), n = strlen(b);
  if (m >= LONGEST || n >= LONGEST)
    return LONGEST;
  int *two = row[0], *one = row[1], *now = row[2];
  for (size_t j = 0; j <= n; j++)
    one[j] = (int)j;
  int before_x = 0; /* the letters before x and y; 0 before the first ones, which equals no letter */
  for (size_t i = 1; i <= m; i++) {
    const int x = tolower((unsigned char)a[i - 1]);
    int before_y = 0;
    now[0] = (int)i;
    for (size_t j = 1; j <= n; j++) {
      const int y = tolower((unsigned char)b[j - 1]);
      int best = one[j - 1] + (x != y);
      if (one[j] + 1 < best)
        best = one[j] + 1;
      if (now[j - 1] + 1 < best)
        best = now[j - 1] + 1;
      if (x == before_y && y == before_x && x != y && two[j - 2] + 1 < best)
        best = two[j - 2] + 1;
      now[j] = best;
      before_y = y;
    }
    before_x = x;
    int *spare = two;
    two = one;
    one = now;
    now = spare;
  }
  return one[n];
}

struct nb_guess nb_guess_begin(const char *word) {
  return (struct nb_guess){.word = word, .synonym = nb_synonym(word), .distance = 2 * NB_NAME_SIZE};
}

/* Marks the suggested keywords that begin with the known word; false: there are none. */
static bool mark(struct nb_guess *guess, const char *known) {
  const char *list = guess->synonym ? guess->synonym->ours : "";
  char item[NB_NAME_SIZE];
  const size_t length = strlen(known);
  bool found = false;
  for (unsigned bit = 1; nb_item(&list, item); bit <<= 1)
    if (strncmp(item, known, length) == 0 && (!item[length] || item[length] == ' '))
      guess->marked |= bit, found = true;
  return found;
}

/* True if the first, second or last part of the known word between dots is `word`, which must have at least three
 * letters: `energy` and `kinetic` in `energy.kinetic`, `normal` in `M.normal.max`. */
static bool is_related(const char *known, const char *word, size_t length) {
  const char *const first = strchr(known, '.');
  if (length < 3 || !first)
    return false;
  const bool begins = strncmp(known, word, length) == 0 && known[length] == '.';
  const bool follows = strncmp(first + 1, word, length) == 0 && strchr(".", first[length + 1]);
  return begins || follows || strcmp(strrchr(known, '.') + 1, word) == 0;
}

/* True if the known word is the last part of the word: `yy` of `stress.yy`. */
static bool is_last_part(const char *known, const char *word) {
  const char *const dot = strrchr(word, '.');
  return dot && known[0] && known[1] && strcmp(dot + 1, known) == 0;
}

void nb_guess_offer(struct nb_guess *guess, const char *known) {
  const bool marked = mark(guess, known), related = !marked && is_related(known, guess->word, strlen(guess->word));
  const int d = marked ? 0 : related || is_last_part(known, guess->word) ? 1 : distance(guess->word, known);
  if (related && guess->related_count++ < NB_RELATED_MAX)
    nb_append_item(guess->related, sizeof guess->related, known, false);
  if (d >= guess->distance || strlen(known) >= sizeof guess->best)
    return;
  guess->distance = d;
  strcpy(guess->best, known);
}

/* True if the best keyword is near enough: no typing error in words of one or two letters, at most one in words of 3 to
 * 5 letters, two in words of 6 to 9 letters, three in longer words. */
bool nb_guess_found(const struct nb_guess *guess) {
  size_t length = strlen(guess->word);
  int allowed = length < 3 ? 0 : length < 6 ? 1 : length < 10 ? 2 : 3;
  return guess->best[0] && guess->distance <= allowed;
}

/* True if the note of a synonym shows, between backquotes, how a marked keyword is written. Then no question follows
 * the note. */
static bool shows_marked(const struct nb_guess *guess) {
  const char *list = guess->synonym->ours, *const note = guess->synonym->note;
  char item[NB_NAME_SIZE];
  for (unsigned bit = 1; nb_item(&list, item); bit <<= 1)
    for (const char *at = note; guess->marked & bit && (at = strstr(at, item)); at++) {
      bool quoted = false;
      for (const char *c = note; c < at; c++)
        quoted ^= *c == '`';
      if (quoted && strchr("` ", at[-1]))
        return true;
    }
  return false;
}

const char *nb_guess_hint(const struct nb_guess *guess, char *text) {
  if (!nb_guess_found(guess))
    return NULL;
  char list[NB_HINT_SIZE / 2];
  snprintf(list, sizeof list, "`%s`", guess->best);
  if (guess->related_count > 1 && guess->distance > 0) /* then `best` is one of the related keywords */
    snprintf(list, sizeof list, "%s%s", guess->related, guess->related_count > NB_RELATED_MAX ? ", …" : "");
  if (guess->marked)
    list_ours(list, guess->synonym, guess->marked);
  const char *const note = guess->marked && guess->synonym->note ? guess->synonym->note : "";
  if (*note && shows_marked(guess))
    snprintf(text, NB_HINT_SIZE, "%s", note);
  else
    snprintf(text, NB_HINT_SIZE, "%s%sdid you mean %s?", note, *note ? ": " : "", list);
  return text;
}
