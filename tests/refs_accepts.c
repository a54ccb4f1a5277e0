/* What each reference covers, by feature: the theories that include a feature, and why. A reference with a wrong list
 * would solve a scene that its theory does not describe, or refuse one that it describes.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <CUnit/CUnit.h>
#include <string.h>

#include "reference.h"
#include "suites.h"

/* References separated by spaces. `!` follows the references that need the feature; `|` separates groups and has no
 * meaning. */
struct covering {
  enum nb_feature feature;
  const char *references;
};

/* Groups of references with the same theory. */
#define HERTZ_IMPACTS "hertz_damped hertz_deep hertz_impact hertz_increment hertz_phase "
#define NETWORKS "nine_discs nine_discs_distortion nine_discs_slip nine_discs_statics "
#define NETWORKS_AT_REST "nine_discs_distortion nine_discs_slip nine_discs_statics "
#define ROWS "two_wall_compression two_wall_statics "
#define PATHS "path_no_slip path_randall path_springs "

/* clang-format off */
static const struct covering coverings[] = {
  /* The mass of a disc follows from its shape, and a linear spring does not depend on it. Moduli in Pa need the thickness
   * of discs. */
  {HAS_DISCS, NETWORKS ROWS
   "boxed_lattice carried chain cohesion filling force_chain fracc fracc_touch free_fall incline lattice_moduli "
   "lattice_stress lattice_waves many_bounces measures momentum one_contact packing rebound ring_strain rotation_off "
   "servo_lattice slide_to_roll speed_of_loading step_limit taken_out time_reversal turning_wall wall_end wedge zigzag"},
  /* Hertz's law is for spheres. */
  {HAS_SPHERES, HERTZ_IMPACTS PATHS NETWORKS ROWS
   "contact_ladder hertz_curve hertz_row literal_field mindlin_loops oblique_impact pinched rayleigh_cycle rayleigh_step "
   "rigid_impact stress_ring changed_law centripetal | carried chain filling free_fall incline lattice_moduli "
   "lattice_waves many_bounces measures momentum one_contact packing rebound ring_strain rotation_off slide_to_roll "
   "stacked step_limit taken_out time_reversal turning_wall wall_end wedge"},
  /* A fixed particle is a particle of infinite mass in an impact, and a support in statics. */
  {HAS_FIXED_PARTICLES, HERTZ_IMPACTS NETWORKS "oblique_impact rebound one_contact step_limit measures pinched! zigzag!"},
  /* Motion from an initial velocity, or none left at the end (wedge); a uniform velocity has no effect (momentum). */
  {HAS_VELOCITIES, HERTZ_IMPACTS
   "chain fracc fracc_touch lattice_waves momentum oblique_impact one_contact pinched rayleigh_cycle rayleigh_step "
   "rebound rigid_impact ring_strain rotation_off slide_to_roll stacked taken_out time_reversal turning_wall wall_end "
   "wedge"},
  /* The equation of rotation is solved, or the rotational energy counted. */
  {HAS_SPINS, "momentum oblique_impact one_contact rebound rotation_off taken_out time_reversal turning_wall"},
  {HAS_IMPACT, HERTZ_IMPACTS "oblique_impact! rebound! rigid_impact!"},
  {HAS_WALLS, HERTZ_IMPACTS PATHS
   "contact_ladder hertz_curve mindlin_loops oblique_impact one_contact packing rebound step_limit taken_out "
   "time_reversal | boxed_lattice! chain! changed_law! cohesion! force_chain! fracc! free_fall! hertz_row! incline! "
   "many_bounces! nine_discs! nine_discs_distortion! nine_discs_slip! nine_discs_statics! rigid_impact! rotation_off! "
   "slide_to_roll! speed_of_loading! stacked! turning_wall! two_wall_compression! two_wall_statics! wall_end! wedge! "
   "zigzag!"},
  /* Only the velocity relative to the wall counts, or the wall loads the assembly. */
  {HAS_MOVING_WALLS, HERTZ_IMPACTS NETWORKS ROWS
   "changed_law cohesion hertz_curve oblique_impact one_contact rebound speed_of_loading step_limit time_reversal "
   "wall_end"},
  {HAS_TURNING_WALLS, NETWORKS "time_reversal turning_wall!"},
  {HAS_OFFSET_WALLS, NETWORKS ROWS "time_reversal turning_wall wedge"},
  {HAS_CELL, "momentum lattice_moduli! lattice_waves! servo_lattice!"},
  {HAS_CONTACT_TEST, "hertz_curve contact_ladder! mindlin_loops! path_no_slip! path_randall! path_springs!"},
  /* Friction acts along a contact, and the theory has it or requires that nothing slides. */
  {HAS_FRICTION, PATHS NETWORKS ROWS
   "changed_law cohesion contact_ladder filling incline lattice_moduli lattice_waves literal_field mindlin_loops momentum "
   "oblique_impact one_contact packing rotation_off servo_lattice slide_to_roll step_limit | rebound! rigid_impact! "
   "turning_wall!"},
  {HAS_COHESION, "cohesion momentum nine_discs nine_discs_statics one_contact slide_to_roll"},
  {HAS_MEMORY, "changed_law momentum oblique_impact rebound"},
  {HAS_GRAVITY, "incline stacked time_reversal | free_fall! many_bounces! rotation_off! slide_to_roll! wedge!"},
  {HAS_CENTRIPETAL_GRAVITY, "centripetal!"},
  /* Dashpots do not change a state of rest; otherwise the equation of motion has them. */
  {HAS_STIFFNESS_DAMPING, NETWORKS_AT_REST ROWS
   "boxed_lattice centripetal cohesion free_fall incline literal_field many_bounces momentum one_contact rotation_off "
   "slide_to_roll step_limit stress_ring turning_wall"},
  {HAS_R89_FRACTION_DAMPING, NETWORKS_AT_REST ROWS
   "boxed_lattice centripetal cohesion free_fall incline literal_field many_bounces momentum rotation_off slide_to_roll "
   "step_limit stress_ring turning_wall"},
  {HAS_RATIO_DAMPING, NETWORKS_AT_REST ROWS
   "boxed_lattice centripetal cohesion free_fall incline literal_field many_bounces momentum rotation_off slide_to_roll "
   "step_limit stress_ring turning_wall | hertz_curve hertz_damped hertz_deep one_contact rebound stacked"},
  {HAS_WALL_DAMPING, NETWORKS_AT_REST ROWS
   "boxed_lattice centripetal cohesion free_fall incline literal_field many_bounces rotation_off slide_to_roll "
   "step_limit stress_ring turning_wall | hertz_damped hertz_deep one_contact"},
  {HAS_CRITICAL_DAMPING, NETWORKS_AT_REST ROWS "boxed_lattice centripetal momentum stress_ring hertz_deep!"},
  {HAS_CENTRED_DASHPOTS, "hertz_damped one_contact rebound"},
  /* Forces on particles, not between them: they change a momentum. */
  {HAS_MASS_DAMPING, NETWORKS_AT_REST ROWS "boxed_lattice centripetal hertz_row step_limit stress_ring wedge "
   "speed_of_loading!"},
  {HAS_CON1_CS79, NETWORKS_AT_REST ROWS "boxed_lattice carried centripetal ring_strain step_limit stress_ring"},
  {HAS_CON1_VELOCITY, NETWORKS_AT_REST ROWS "boxed_lattice carried centripetal ring_strain step_limit stress_ring"},
  {HAS_CON1_ALL, NETWORKS_AT_REST ROWS "boxed_lattice carried centripetal ring_strain step_limit stress_ring"},
  {HAS_BOUNDARY, "literal_field ring_strain! stress_ring!"},
  {HAS_BOUNDARY_STRAIN, "literal_field ring_strain"},
  {HAS_BOUNDARY_STRESS, "stress_ring!"},
  {HAS_BOUNDARY_NONE, ""},
  {HAS_AFFINE_STRAIN, "literal_field carried! ring_strain!"},
  {HAS_AFFINE_ACCUMULATED, "carried ring_strain literal_field!"},
  {HAS_AFFINE_TWICE, ""},
  {HAS_CELL_STRAIN, "lattice_moduli momentum servo_lattice"},
  {HAS_BOX_STRAIN, "boxed_lattice"},
  {HAS_SERVO, "boxed_lattice servo_lattice"},
  {HAS_START, "literal_field nine_discs"},
  {HAS_ROTATION_OFF, "lattice_waves rotation_off"},
  /* Velocities have no effect on a state of rest. */
  {HAS_ZERO_VELOCITIES, "boxed_lattice literal_field wedge"},
  {HAS_REVERSE_VELOCITIES, "time_reversal!"},
  {HAS_REMOVE, "taken_out!"},
  {HAS_REMOVE_WALL, "taken_out"},
  /* The value is that of a state that lasts, or the end of the stage is computed. */
  {HAS_UNTIL, HERTZ_IMPACTS NETWORKS_AT_REST
   "centripetal chain free_fall hertz_row literal_field many_bounces momentum oblique_impact pinched rayleigh_cycle "
   "rayleigh_step rebound rigid_impact rotation_off slide_to_roll stress_ring two_wall_statics wedge"},
  {HAS_RAMP, "boxed_lattice hertz_curve incline servo_lattice"},
  /* The step has no effect, or the time is the sum over the stages. */
  {HAS_STEP_CHANGE, NETWORKS_AT_REST ROWS "boxed_lattice changed_law literal_field momentum wedge"},
  {HAS_DAMPING_CHANGE, NETWORKS_AT_REST ROWS
   "boxed_lattice centripetal momentum rotation_off stress_ring turning_wall wedge"},
  {HAS_LAW_CHANGE, "changed_law"},
  {HAS_GRAVITY_CHANGE, "centripetal incline wedge"},
  {HAS_MATERIAL_CHANGE, "literal_field momentum rotation_off"},
};

/* The laws for which the equations of a reference hold. With `*` the law has no effect. */
static const struct {
  const char *law, *normal, *shear;
} laws[] = {
  {"*", "carried centripetal filling momentum ring_strain", "filling momentum"},
  {"linear", NETWORKS ROWS
   "boxed_lattice chain changed_law cohesion force_chain fracc fracc_touch free_fall incline lattice_moduli "
   "lattice_stress lattice_waves many_bounces measures one_contact packing rebound rotation_off servo_lattice "
   "slide_to_roll speed_of_loading stacked step_limit taken_out time_reversal turning_wall wall_end wedge zigzag",
   NETWORKS ROWS
   "changed_law cohesion contact_ladder incline lattice_moduli lattice_waves oblique_impact one_contact packing "
   "path_no_slip rebound rotation_off servo_lattice slide_to_roll speed_of_loading step_limit turning_wall"},
  {"hertz", PATHS
   "changed_law contact_ladder hertz_curve hertz_damped hertz_deep hertz_impact hertz_phase hertz_row lattice_moduli "
   "literal_field mindlin_loops oblique_impact pinched rayleigh_cycle rayleigh_step rebound rigid_impact stress_ring "
   "time_reversal", ""},
  {"hertz_increment", "changed_law hertz_impact hertz_increment", ""},
  {"none", "", HERTZ_IMPACTS NETWORKS ROWS
   "boxed_lattice carried centripetal chain changed_law force_chain fracc fracc_touch free_fall hertz_curve hertz_row "
   "lattice_moduli lattice_stress many_bounces measures oblique_impact one_contact packing pinched rayleigh_cycle "
   "rayleigh_step ring_strain speed_of_loading stacked step_limit stress_ring taken_out time_reversal wall_end wedge "
   "zigzag"},
  {"mindlin", "", "changed_law contact_ladder literal_field mindlin_loops oblique_impact path_no_slip rebound"},
  {"mindlin_scaled", "", "contact_ladder mindlin_loops oblique_impact path_no_slip rebound"},
  {"mindlin_deresiewicz", "", "changed_law contact_ladder mindlin_loops oblique_impact path_no_slip path_springs rebound "
   "rigid_impact"},
  {"randall", "", "contact_ladder mindlin_loops oblique_impact path_randall rebound"},
  {"randall_literal", "", "contact_ladder path_randall rebound"},
};
/* clang-format on */

/* Whether a list of words separated by spaces has the word; with `!` behind it if `mark`. */
static bool has_word(const char *list, const char *word, bool mark) {
  char marked[NB_NAME_SIZE + 1];
  snprintf(marked, sizeof marked, "%s%s", word, mark ? "!" : "");
  for (const char *at = list; *at; at += strcspn(at, " "), at += strspn(at, " "))
    if (strlen(marked) == strcspn(at, " ") && strncmp(at, marked, strlen(marked)) == 0)
      return true;
  return false;
}

static bool lists(const enum nb_feature list[], size_t size, enum nb_feature feature) {
  for (size_t k = 0; k < size && list[k] != HAS_NOTHING; k++)
    if (list[k] == feature)
      return true;
  return false;
}

static void features_that_references_accept_and_need(void) {
  CU_ASSERT_EQUAL_FATAL(sizeof coverings / sizeof *coverings, NB_FEATURES - 1);
  for (size_t k = 0; k < sizeof coverings / sizeof *coverings; k++)
    for (const struct nb_reference *const *it = nb_references(); *it; it++) {
      const struct covering *row = &coverings[k];
      const bool needs = has_word(row->references, (*it)->name, true);
      const bool accepts = has_word(row->references, (*it)->name, false);
      CU_ASSERT_EQUAL_FATAL(row->feature, (enum nb_feature)(k + 1));
      const bool right = lists((*it)->needs, sizeof(*it)->needs / sizeof *(*it)->needs, row->feature) == needs &&
                         lists((*it)->accepts, NB_FEATURES, row->feature) == accepts;
      if (!right)
        printf("# %s: `%s` should%s be %s\n", (*it)->name, nb_feature_name(row->feature),
               needs || accepts ? "" : " not", needs ? "needed" : "accepted");
      CU_ASSERT(right);
    }
}

static void laws_that_references_accept(void) {
  size_t words[2] = {0};
  for (size_t k = 0; k < sizeof laws / sizeof *laws; k++)
    for (const struct nb_reference *const *it = nb_references(); *it; it++)
      for (int shear = 0; shear < 2; shear++) {
        const char *accepted = shear ? (*it)->shear : (*it)->normal;
        const bool expected = has_word(shear ? laws[k].shear : laws[k].normal, (*it)->name, false);
        words[shear] += expected;
        if (has_word(accepted, laws[k].law, false) != expected)
          printf("# %s: %s %s\n", (*it)->name, shear ? "shear" : "normal", laws[k].law);
        CU_ASSERT_EQUAL(has_word(accepted, laws[k].law, false), expected);
      }
  for (const struct nb_reference *const *it = nb_references(); *it; it++) /* there are no other laws in the lists */
    for (int shear = 0; shear < 2; shear++)
      for (const char *at = shear ? (*it)->shear : (*it)->normal; *at; at += strcspn(at, " "), at += strspn(at, " "))
        words[shear]--;
  CU_ASSERT_EQUAL(words[0], 0);
  CU_ASSERT_EQUAL(words[1], 0);
}

void suite_refs_accepts(void) {
  CU_pSuite suite = CU_add_suite("refs_accepts", NULL, NULL);
  CU_ADD_TEST(suite, features_that_references_accept_and_need);
  CU_ADD_TEST(suite, laws_that_references_accept);
}
