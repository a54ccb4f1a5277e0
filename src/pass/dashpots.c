/* Contact dashpots. Their forces are added to the contact force, never to the contact history. [CS79 24-28; R89 4.3,
 * 4.13]
 *
 *   D_n = c_n dn/dt,   D_s = c_s ds/dt                                  [CS79 26, 27]
 *   c = beta k                  `damping stiffness`, beta a time       [CS79 28]
 *   c = beta k t_c/2            `damping r89-fraction`; R89 writes D_n = dN beta/(2 FRAC)  [R89 4.3, 4.4]
 *                               with dN = k dn and dt = FRAC t_c
 *   c = beta 2 sqrt(M* k)       `damping ratio`, beta a fraction of critical  [R89 4.13, 4.19]
 *   c = 2 sqrt(M* k)            `critical beyond overlap`, for deep contacts in place of the others [R89 sec. 6.4.3]
 *
 *   D_n, D_s  forces of the normal and the shear dashpot, N      c, c_n, c_s  coefficients, N s/m
 *   k    stiffness, N/m: k_n for c_n and k_s for c_s; for elastic spheres 2 E* a and 8 G* a,
 *        with the shear laws of R89 8 G* a theta
 *   t_c  single-contact step 2 sqrt(m/k), s                      M*  reduced mass, kg
 *
 * Contacts with walls may have their own beta.
 *
 * If no coefficient contains sqrt(M* k), no M* is kept and no square root is computed. If the laws have constant
 * stiffnesses and the page does not damp deep contacts critically, the roots are stored for each contact instead of M*.
 * They are computed again when the pair's k_n or k_s changes.
 *
 * The stiffnesses are those that the laws returned in this cycle. D_s is 0 while the contact slides [CS79, Damping];
 * F_n + D_n may be tensile. ds/dt is the mean over the whole last step, even if the contact began in it and the law
 * used only a part of ds. The friction limit of F_s was computed from F_n alone, before this pass.
 *
 * With `damping centred` the rates are those at the time of the force: dn/dt + (u_x - u_y).e. Here e is the unit vector
 * from particle x to particle (or wall) y, and u_x and u_y are the predicted changes of their velocities at the contact
 * in the last half step, m/s (core/motion.c). At time 0 the rates follow from the velocities of the page; in CS79's
 * scheme they are then 0. At first touch the force of a dashpot jumps, or with Hertz's law rises steeply, so the scheme
 * is of second order only with a correction there. The force at t_N acts from t_(N-1/2) to t_(N+1/2). Let t_N be the
 * first time after first touch, and f the time from first touch to t_N, over dt. No force acts before t_(N-1/2), but at
 * t_(N+1/2) the contact has existed for the time (f + 1/2) dt. Near first touch c is proportional to alpha^p, with p =
 * 0 for linear springs, 1/2 for the stiffness of elastic spheres and 1/4 for the root of this stiffness. So the force
 * is multiplied by
 *
 *   w(f) = Int_0^(f+1/2) t^p dt / f^p = (f + 1/2)^(1+p)/((1 + p) f^p)
 *
 * The end of a contact is treated in the same way, backwards in time: f is then the time from t_N to the end over dt.
 * This f is known only one cycle later, when the contact has opened. In that later cycle w(f) - 1 times the force at
 * t_N acts on the particles. For this purpose the force at t_N is computed again, from the previous overlap and the
 * rate over the last step. The tangential dashpot has no such term, because a contact without cohesion slides before it
 * ends.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "laws/law.h"
#include "pass.h"

struct nb_dashpot nb_dashpot(const struct nb_model *model, bool wall) {
  double beta;
  switch (nb_damping_at(&model->damping, wall, &beta)) {
  case NB_CONTACT_STIFFNESS:
    return (struct nb_dashpot){.time = beta};
  case NB_CONTACT_R89_FRACTION:
    return (struct nb_dashpot){.time = beta * model->critical / 2};
  case NB_CONTACT_RATIO:
    return (struct nb_dashpot){.ratio = 2 * beta};
  case NB_CONTACT_UNDAMPED:
    break;
  }
  return (struct nb_dashpot){0};
}

/* What the coefficients of a block depend on. */
struct dashpots {
  struct nb_dashpot dashpot;
  bool uses_damping_ratio, critical; /* some coefficients contain sqrt(M* k); deep contacts are damped critically */
  const double *mass, *deep;         /* M*, kg; NB_DEEP */
  const double *normal_root, *shear_root; /* sqrt(M* k) of the contacts with k > 0; NULL: not stored */
};

/* Coefficient of a dashpot of contact c of the block, N s/m. `stiffness`: k of the contact, N/m; `root`:
 * spec->normal_root or spec->shear_root. */
static inline NB_FORM double coefficient(const struct dashpots *spec, double stiffness, const double *root, size_t c) {
  const double oscillation = !spec->uses_damping_ratio ? 0
                             : root                    ? nb_where(stiffness > 0, root[c])
                                                       : sqrt(spec->mass[c] * stiffness); /* sqrt(M* k) */
  return spec->critical && spec->deep[c] > 0 ? 2 * oscillation
                                             : spec->dashpot.time * stiffness + spec->dashpot.ratio * oscillation;
}

/* Changes of relative velocities in the last half step; at time 0, before the first step, the velocities themselves. */
struct changes {
  struct nb_vec approach[NB_BLOCK_SIZE]; /* change of v_x - v_y, m/s */
  double rotation[NB_BLOCK_SIZE];        /* change of w_x R_x + w_y R_y, m/s */
};

/* The changes of the velocity and, as `spin`, of the surface speed of particle i, m/s, as in struct changes. `start`:
 * at time 0. */
static inline NB_FORM struct nb_velocities change_of(const struct nb_particles *particles, int i, bool start) {
  return start ? (struct nb_velocities){particles->velocity[i], particles->surface_speed[i]} : particles->ahead[i];
}

/* The change, as in struct changes, for the point of wall w nearest to x, the centre of a particle: the velocity of
 * this point at the end of the step minus its mean velocity over the step; at time 0, its velocity. */
static inline NB_FORM struct nb_vec wall_change(const struct nb_walls *walls, int w, struct nb_vec x, bool start) {
  const struct nb_vec q = nb_wall_nearest(walls, w, x), arm = vec_sub(q, walls->pivot[w]);
  const struct nb_vec v = vec_add(walls->velocity[w], vec_scale(walls->spin[w], vec(-arm.y, arm.x)));
  return start ? v : vec_sub(v, nb_wall_velocity(walls, w, q));
}

/* Sets `changes` for all contacts of a block. */
static inline NB_FORM void predict(struct changes *changes, const struct nb_model *model, const struct nb_block *block,
                                   bool start) {
  const struct nb_particles *particles = &model->particles;
  for (size_t c = 0; c < block->n; c++) {
    const struct nb_velocities one = change_of(particles, block->a[c], start);
    struct nb_velocities other = {.spin = 0};
    if (block->material_pair->wall)
      other.velocity = wall_change(&model->walls, block->b[c], particles->position[block->a[c]], start);
    else
      other = change_of(particles, block->b[c], start);
    changes->approach[c] = vec_sub(one.velocity, other.velocity);
    changes->rotation[c] = one.spin + other.spin;
  }
}

/* An overlap smaller than this fraction of the displacement in the step counts as rounding: a touch at the end of a
 * step then belongs to the next step, with f = 1, whatever the sign of the overlap. Rounding is smaller than this
 * fraction even if the coordinates are 1e6 times the displacement. */
static const double touch_rounding = 1e-9;
/* As nb_touch_began, but a touch at the end of the previous step counts as a touch in this step. */
static inline NB_FORM bool just_began(double overlap, double dn) {
  return overlap > 0 && overlap < dn * (1 + touch_rounding);
}

/* w(f), the factor of a dashpot's force at first touch and at the end of a contact. */
static double weight(const struct dashpots *spec, const struct nb_law *law, double f) {
  static const double least = 1e-6; /* keeps f^(-p) finite; c is proportional to f^p */
  const double from = f > least ? f : least, to = from + 0.5, root = sqrt(to / from);
  if (!law->elastic)
    return to;
  return spec->dashpot.ratio > 0 ? to * sqrt(root) / 1.25 : to * root / 1.5;
}

/* The force of the normal dashpot that acts although contact c has opened in the last step: w(f) - 1 times the force
 * one step earlier, N; 0 if the contact did not open in the last step. */
static double end_force(const struct dashpots *spec, const struct nb_model *model, const struct nb_block *block,
                        size_t c) {
  const struct nb_law *law = block->material_pair->normal;
  const size_t contact = (size_t)(block->a - model->contacts.a) + c;
  const double dn = block->f[NB_NORMAL_INCREMENT][c], after = nb_overlap(model, contact), before = after - dn;
  double history[NB_HISTORY] = {0};
  if (!(after <= 0 && before > 0) || (model->contacts.suppressed && model->contacts.suppressed[contact]))
    return 0;
  const struct nb_pair values = nb_contact_constants(model, contact, block->material_pair->values);
  const double k = law->normal(values, before, before, history).stiffness;
  return (weight(spec, law, -before / dn) - 1) * coefficient(spec, k, spec->normal_root, c) * dn / model->previous_step;
}

/* Multiplies the forces of the dashpots of contact c by w. */
static void multiply(const struct nb_block *block, size_t c, double w) {
  const double normal = block->f[NB_NORMAL][c], shear = block->f[NB_SHEAR][c];
  block->f[NB_TOTAL_NORMAL][c] = normal + w * (block->f[NB_TOTAL_NORMAL][c] - normal);
  if (block->material_pair->shear)
    block->f[NB_TOTAL_SHEAR][c] = shear + w * (block->f[NB_TOTAL_SHEAR][c] - shear);
}

/* Corrects the forces of contacts that began or ended in the last step. */
static NB_COLD void correct_touches(const struct dashpots *spec, const struct nb_model *model,
                                    const struct nb_block *block) {
  const double *overlap = block->f[NB_OVERLAP], *dn = block->f[NB_NORMAL_INCREMENT];
  for (size_t c = 0; c < block->n; c++) {
    const double f = overlap[c] / dn[c];
    if (!(overlap[c] > 0) && dn[c] < 0)
      block->f[NB_TOTAL_NORMAL][c] = end_force(spec, model, block, c);
    if (just_began(overlap[c], dn[c]))
      multiply(block, c, f > touch_rounding ? weight(spec, block->material_pair->normal, f) : 0);
  }
}

/* Called at time 0. Contacts that touch within rounding begin in the next step, so their dashpots have no force yet. */
static NB_COLD void defer_touches(const struct nb_model *model, const struct nb_block *block,
                                  const struct changes *velocities) {
  for (size_t c = 0; c < block->n; c++) {
    const struct nb_vec e = vec(block->f[NB_EX][c], block->f[NB_EY][c]);
    if (block->f[NB_OVERLAP][c] < touch_rounding * model->step * vec_dot(velocities->approach[c], e))
      multiply(block, c, 0);
  }
}

/* The tangential velocity of contact c, m/s, from its displacement in the last step, m; `rate`: 1/dt. `changes` is NULL
 * unless the dashpots are centred. */
static inline NB_FORM double slip_rate(const struct nb_block *block, const struct changes *changes, size_t c,
                                       double displacement, double rate) {
  if (!changes)
    return displacement * rate;
  const struct nb_vec e = vec(block->f[NB_EX][c], block->f[NB_EY][c]);
  return displacement * rate + (vec_dot(changes->approach[c], vec_clockwise(e)) - changes->rotation[c]);
}

/* Adds the forces of the shear dashpots. `rate`: 1/dt. `changes` is NULL unless the dashpots are centred. */
static inline NB_FORM void add_tangential(const struct dashpots *spec, const struct nb_block *block, double rate,
                                          const struct changes *changes) {
  const double *shear = block->f[NB_SHEAR], *shear_stiffness = block->f[NB_SHEAR_STIFFNESS];
  const double *dn = block->f[NB_NORMAL_INCREMENT];
  const double *ds = block->f[NB_TANGENTIAL_INCREMENT], *sliding = block->f[NB_SLIDING],
               *overlap = block->f[NB_OVERLAP];
  double *total_shear = block->f[NB_TOTAL_SHEAR];
  NB_WIDE
  for (size_t c = 0; c < block->n; c++) {
    const double slip = slip_rate(block, changes, c, ds[c], rate);
    total_shear[c] = shear[c] + (1 - sliding[c]) * (coefficient(spec, shear_stiffness[c], spec->shear_root, c) * slip);
  }
  for (size_t c = 0; c < block->n && *block->began; c++) { /* new contacts, whose ds is not that of the whole step */
    const double fraction = nb_touch_fraction(overlap[c], dn[c]),
                 displacement = fraction > 0 ? ds[c] / fraction : ds[c],
                 whole = slip_rate(block, changes, c, displacement, rate);
    if (nb_touch_began(overlap[c], dn[c]))
      total_shear[c] =
          shear[c] + (1 - sliding[c]) * (coefficient(spec, shear_stiffness[c], spec->shear_root, c) * whole);
  }
}

/* Computes the roots of a block for the stiffnesses that its material pair has now. */
static NB_COLD void renew_roots(const struct nb_model *model, const struct nb_block *block) {
  const struct nb_pair *pair = &block->material_pair->values;
  *block->rooted = (struct nb_rooted){pair->kn, pair->ks};
  for (size_t c = 0; c < block->n; c++) {
    const double mass = nb_reduced_mass(&model->particles, block->a[c], block->material_pair->wall ? -1 : block->b[c]);
    block->f[NB_NORMAL_ROOT][c] = sqrt(mass * pair->kn);
    if (block->material_pair->shear)
      block->f[NB_SHEAR_ROOT][c] = sqrt(mass * pair->ks);
  }
}

static inline NB_FORM void add_forces(const struct dashpots *spec, const struct nb_model *model,
                                      const struct nb_block *block, bool centred) {
  const double *normal = block->f[NB_NORMAL], *stiffness = block->f[NB_STIFFNESS];
  const double *dn = block->f[NB_NORMAL_INCREMENT], *overlap = block->f[NB_OVERLAP];
  const double *ex = block->f[NB_EX], *ey = block->f[NB_EY];
  double *total_normal = block->f[NB_TOTAL_NORMAL];
  const double rate = model->previous_step > 0 ? 1 / model->previous_step : 0;
  struct changes changes;
  unsigned long ends = 0;
  if (centred)
    predict(&changes, model, block, !(rate > 0));
  NB_WIDE
  for (size_t c = 0; c < block->n; c++) {
    double approach_rate = dn[c] * rate;
    if (centred)
      approach_rate += vec_dot(changes.approach[c], vec(ex[c], ey[c]));
    total_normal[c] = normal[c] + coefficient(spec, stiffness[c], spec->normal_root, c) * approach_rate;
    if (centred)
      ends += just_began(overlap[c], dn[c]) || (!(overlap[c] > 0) && dn[c] < 0);
  }
  if (block->material_pair->shear)
    add_tangential(spec, block, rate, centred ? &changes : NULL);
  if (ends > 0)
    correct_touches(spec, model, block);
  if (centred && !(rate > 0))
    defer_touches(model, block, &changes);
}

static inline NB_FORM void add_dashpots(const struct nb_model *model, const struct nb_block *block,
                                        enum nb_dashpot_kind form, bool centred) {
  struct dashpots spec = {.dashpot = nb_dashpot(model, block->material_pair->wall),
                          .uses_damping_ratio = form >= NB_DASHPOTS_RATIO,
                          .critical = form == NB_DASHPOTS_DEEP && model->damping.deep > 0,
                          .mass = block->f[NB_MASS],
                          .deep = block->f[NB_DEEP]};
  if (form == NB_DASHPOTS_RATIO && block->rooted) {
    const struct nb_pair *pair = &block->material_pair->values;
    if (block->rooted->kn != pair->kn || block->rooted->ks != pair->ks)
      renew_roots(model, block);
    spec.normal_root = block->f[NB_NORMAL_ROOT], spec.shear_root = block->f[NB_SHEAR_ROOT];
    add_forces(&spec, model, block, centred);
  } else {
    spec.normal_root = spec.shear_root = NULL;
    add_forces(&spec, model, block, centred);
  }
}

NB_PASS_FORM(stiffness_proportional, add_dashpots(model, block, NB_DASHPOTS_TIME, false))
NB_PASS_FORM(ratio_of_critical, add_dashpots(model, block, NB_DASHPOTS_RATIO, false))
NB_PASS_FORM(critical_if_deep, add_dashpots(model, block, NB_DASHPOTS_DEEP, false))
NB_PASS_FORM(centred_stiffness_proportional, add_dashpots(model, block, NB_DASHPOTS_TIME, true))
NB_PASS_FORM(centred_ratio_of_critical, add_dashpots(model, block, NB_DASHPOTS_RATIO, true))
NB_PASS_FORM(centred_critical_if_deep, add_dashpots(model, block, NB_DASHPOTS_DEEP, true))

const struct nb_pass nb_pass_dashpots[2][4] = {
    {{"no dashpots", {NULL}},
     {"dashpots", NB_FORMS_LIST(stiffness_proportional)},
     {"dashpots, damping ratio", NB_FORMS_LIST(ratio_of_critical)},
     {"dashpots, critical beyond overlap", NB_FORMS_LIST(critical_if_deep)}},
    {{"no dashpots", {NULL}},
     {"dashpots, centred", NB_FORMS_LIST(centred_stiffness_proportional)},
     {"dashpots, damping ratio, centred", NB_FORMS_LIST(centred_ratio_of_critical)},
     {"dashpots, critical beyond overlap, centred", NB_FORMS_LIST(centred_critical_if_deep)}},
};
