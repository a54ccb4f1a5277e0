/* The neighbour list: pairs of particles, and of particles and walls, closer than the skin. [CS79; R89 sec. 4.3.1, TOL]
 *
 * All pairs with a free particle whose gap is smaller than the skin are listed, touching or not. Until a particle or a
 * wall has moved by more than half the skin, a pair that is not listed cannot touch. A scene in which nothing moves is
 * searched once, when the model is created. If no free particle can touch anything, the skin is infinite and there is
 * no search. A search keeps the history of every contact.
 *
 * Particles are in a grid of boxes with levels by size (grid.h), each on the finest level whose boxes are at least as
 * wide as its diameter plus the skin. For each particle the nine boxes around it are searched, on its own level and on
 * those of larger particles. Scenes of a few particles need no grid. Particles of similar size that fill their
 * surroundings are sorted by box instead (mesh.h), which finds the same pairs faster.
 *
 * In a periodic cell (cell.c) each particle is represented by its image in the cell. The search for its neighbours also
 * starts from those of its images outside the cell that are near the cell. A pair across an edge of the cell is found
 * once: between an image of one particle and the other particle in the cell. The image is that of the particle with the
 * smaller number, but if the particles are on different levels of the grid, that of the particle on the finer level.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include <stdlib.h>
#include <string.h>

#include "grid.h"
#include "mesh.h"
#include "model.h"

enum { GRID_MIN_PARTICLES = 16 }; /* up to this number, and without a cell, all pairs are tested without a grid */

struct search {
  struct nb_mesh mesh; /* without items: the grid is used */
  struct nb_grid grid;
  struct nb_wrap wrap;    /* the periodic cell with the shortest sides */
  struct nb_vec *wrapped; /* for each slot the position of the image in this cell, m; NULL without a cell */
};

static bool wrap_positions(struct search *search, const struct nb_model *model) {
  const size_t n = model->particles.count;
  search->wrapped = nb_array(n, sizeof *search->wrapped);
  search->wrap = nb_cell_wrap(model->cell);
  for (size_t i = 0; i < n && search->wrapped; i++)
    search->wrapped[i] = nb_wrapped(&search->wrap, model->particles.position[i]);
  return search->wrapped != NULL;
}

static inline struct nb_vec wrapped_position(const struct search *search, const struct nb_model *model, int i) {
  return search->wrapped ? search->wrapped[i] : model->particles.position[i];
}

/* Images are sought up to a distance that is larger than necessary by this fraction, so that rounding (1e-16) misses
 * none. */
static const double image_margin = 1e-12;

/* Largest coordinate, in sides of the cell from its centre, of an image that can touch a particle in the cell. `width`:
 * range of a contact, m. */
static double farthest_image(const struct search *search, double width) {
  return (0.5 + width / nb_wrap_width(&search->wrap)) * (1 + image_margin);
}

/* The particles in the periodic cell, and those of their images outside the cell that can touch a particle in it. */
struct images {
  struct nb_vec *x;    /* m */
  int *slot;           /* as in an item of the mesh */
  size_t count, slots; /* lengths of the two arrays; equal */
};

static bool add_image(struct images *images, struct nb_vec x, int slot) {
  struct nb_vec *place = NB_ARRAY_APPEND(images->x, images->count);
  int *number = place ? NB_ARRAY_APPEND(images->slot, images->slots) : NULL;
  if (!number)
    return false;
  *place = x, *number = slot;
  return true;
}

/* Adds particle i, and those of its images that are at most `edge` from the centre (farthest_image). False: out of
 * memory. */
static bool add_images(struct images *images, const struct search *search, int i, double edge) {
  const struct nb_wrap *wrap = &search->wrap;
  const struct nb_vec x = search->wrapped[i], at = tensor_times(wrap->inverse, vec_sub(x, wrap->centre));
  bool ok = add_image(images, x, i);
  for (int m = 0; m < 9 && ok; m++) {
    const struct nb_vec moved = vec(m % 3 - 1, m / 3 - 1);
    if (m != 4 && fabs(at.x + moved.x) <= edge && fabs(at.y + moved.y) <= edge)
      ok = add_image(images, vec_add(x, tensor_times(wrap->h, moved)), -1 - i);
  }
  return ok;
}

static bool mesh_of_cell(struct search *search, const struct nb_model *model, double width) {
  const double edge = farthest_image(search, width);
  struct images images = {0};
  bool ok = true;
  for (int i = 0; i < (int)model->particles.count && ok; i++)
    ok = add_images(&images, search, i, edge);
  ok = ok && nb_mesh_create(&search->mesh, model, (struct nb_mesh_points){images.x, images.slot, images.count}, width);
  free(images.x), free(images.slot);
  return ok;
}

/* Makes the mesh if the particles are of similar size. False: out of memory. */
static bool mesh_begin(struct search *search, const struct nb_model *model, double width) {
  const struct nb_particles *particles = &model->particles;
  if (!(2 * model->search.smallest_radius + model->search.skin > width / 2))
    return true;
  return model->cell
             ? mesh_of_cell(search, model, width)
             : nb_mesh_create(&search->mesh, model,
                              (struct nb_mesh_points){.x = particles->position, .count = particles->count}, width);
}

static bool search_begin(struct search *search, const struct nb_model *model) {
  const struct nb_particles *particles = &model->particles;
  double largest = 0;
  for (size_t i = 0; i < particles->count; i++)
    largest = particles->radius[i] > largest ? particles->radius[i] : largest;
  const double width = 2 * largest + model->search.skin;
  if ((model->cell && !wrap_positions(search, model)) || !mesh_begin(search, model, width))
    return false;
  if (search->mesh.count)
    return true;
  if (!nb_grid_create(&search->grid, particles->count, width))
    return false;
  for (int i = 0; i < (int)particles->count; i++)
    nb_grid_add(&search->grid, i, wrapped_position(search, model, i), 2 * particles->radius[i] + model->search.skin);
  return true;
}

/* Reserves memory for `more` further pairs. False: out of memory. */
static bool pairs_reserve(struct nb_neighbour_pairs *pairs, size_t more) {
  struct nb_neighbour_pair *list =
      more < SIZE_MAX / sizeof *list - pairs->count ? realloc(pairs->list, (pairs->count + more) * sizeof *list) : NULL;
  if (list)
    pairs->list = list, pairs->capacity = pairs->count + more;
  return list != NULL;
}

static bool pairs_add(struct nb_neighbour_pairs *pairs, int a, int b, int material_pair) {
  if (pairs->count == pairs->capacity && !pairs_reserve(pairs, pairs->count))
    return false;
  pairs->list[pairs->count++] = (struct nb_neighbour_pair){a, b, material_pair};
  return true;
}

static int material_pair_of(const struct nb_model *model, int material_a, int material_b, bool wall) {
  for (size_t p = 0; p < model->material_pair_count; p++) {
    const struct nb_material_pair *q = &model->material_pairs[p];
    if (q->wall == wall &&
        ((q->a == material_a && q->b == material_b) || (!wall && q->a == material_b && q->b == material_a)))
      return (int)p;
  }
  return -1;
}

/* Stores a pair whose overlap exceeds the limit, unless an earlier pair, in the order of the particles' numbers, is
 * stored already. */
static void note_too_deep(struct nb_model *model, struct nb_close_pair pair) {
  const int *number = model->particles.number;
  struct nb_close_pair *first = &model->search.too_deep;
  if (!(first->overlap > 0) || number[pair.a] < number[first->a] ||
      (pair.a == first->a && number[pair.b] < number[first->b]))
    *first = pair;
}

/* Lists particles i and j, whose gap is smaller than the skin; `distance`: of their centres, m. The particle with the
 * smaller number comes first. A pair whose overlap exceeds the limit ends the run. The search then lists no further
 * pairs, because pairs of many coincident particles would fill the memory. False: out of memory. */
static bool near_pair(struct nb_neighbour_pairs *pairs, struct nb_model *model, int i, int j, double distance) {
  const struct nb_particles *particles = &model->particles;
  const double one = particles->radius[i], other = particles->radius[j];
  if (!(particles->inverse_mass[i] > 0 || particles->inverse_mass[j] > 0))
    return true; /* both are fixed: no force between them */
  if (nb_removed(model, (size_t)i) || nb_removed(model, (size_t)j))
    return true;
  const int a = particles->number[i] < particles->number[j] ? i : j, b = a == i ? j : i;
  model->search.check_pairs =
      model->search.check_pairs || !(distance > (one > other ? one : other) + model->search.skin);
  if (one + other - distance > (one < other ? one : other))
    note_too_deep(model, (struct nb_close_pair){a, b, one + other - distance});
  return model->search.too_deep.overlap > 0 ||
         pairs_add(pairs, a, b, material_pair_of(model, particles->material[a], particles->material[b], false));
}

/* Lists particles i and j if their gap is smaller than the skin; `apart`: the vector between their centres, m. False:
 * out of memory. */
static bool neighbour_pair(struct nb_neighbour_pairs *pairs, struct nb_model *model, int i, int j,
                           struct nb_vec apart) {
  const struct nb_particles *particles = &model->particles;
  model->search.candidates++;
  const double distance = vec_length(apart);
  return !(distance < particles->radius[i] + particles->radius[j] + model->search.skin) ||
         near_pair(pairs, model, i, j, distance);
}

/* A particle, and the position from which to search: that of the particle or of one of its images. */
struct origin {
  int i;
  struct nb_vec from; /* m */
};

/* Tests a particle against the particles in one box. On its own level it is tested against particles with larger
 * numbers only, so each pair is tested once. False: out of memory. */
static bool neighbours_in_box(struct nb_neighbour_pairs *pairs, struct nb_model *model, const struct search *search,
                              struct origin origin, struct nb_box box) {
  const int *number = model->particles.number;
  const bool own = box.level == search->grid.entry[origin.i].box.level;
  NB_GRID_FOR_BOX(&search->grid, j, box) {
    if (own && number[j] <= number[origin.i])
      continue;
    if (!neighbour_pair(pairs, model, origin.i, j, vec_sub(wrapped_position(search, model, j), origin.from)))
      return false;
  }
  return true;
}

/* Tests a particle against all particles in the boxes around the origin. False: out of memory. */
static bool neighbours_around(struct nb_neighbour_pairs *pairs, struct nb_model *model, const struct search *search,
                              struct origin origin) {
  const struct nb_grid *grid = &search->grid;
  for (int level = grid->entry[origin.i].box.level; level >= 0; level--) {
    if (!grid->count[level])
      continue;
    const int64_t x = nb_grid_place(grid, level, origin.from.x), y = nb_grid_place(grid, level, origin.from.y);
    for (int64_t dy = -1; dy <= 1; dy++)
      for (int64_t dx = -1; dx <= 1; dx++)
        if (!neighbours_in_box(pairs, model, search, origin, (struct nb_box){level, x + dx, y + dy}))
          return false;
  }
  return true;
}

/* Searches from the image of particle i in the cell, and from those of the eight images around it whose distance from
 * the cell is at most the range of a contact. False: out of memory. */
static bool neighbours_of_images(struct nb_neighbour_pairs *pairs, struct nb_model *model, const struct search *search,
                                 int i) {
  const struct nb_wrap *wrap = &search->wrap;
  const double edge = farthest_image(search, search->grid.width[0]);
  for (int m = 0; m < 9; m++) {
    const struct nb_vec from = vec_add(search->wrapped[i], tensor_times(wrap->h, vec(m % 3 - 1, m / 3 - 1)));
    const struct nb_vec at = tensor_times(wrap->inverse, vec_sub(from, wrap->centre));
    if (fabs(at.x) <= edge && fabs(at.y) <= edge && !neighbours_around(pairs, model, search, (struct origin){i, from}))
      return false;
  }
  return true;
}

/* True if this pair of items counts. Two images outside the cell do not. Across an edge of the cell a pair counts once:
 * if the image outside the cell is that of the particle with the smaller number. */
static bool counts_once(const struct nb_model *model, int slot, int other) {
  const bool image = nb_mesh_is_image(slot), other_image = nb_mesh_is_image(other);
  if (!image && !other_image)
    return true;
  const int number = model->particles.number[nb_mesh_particle(slot)],
            other_number = model->particles.number[nb_mesh_particle(other)];
  return image != other_image && (image ? number < other_number : other_number < number);
}

/* Tests item `it` of the mesh against the items from `from` to `to` - 1. All distances of a batch are computed first,
 * because a loop without branches is faster. False: out of memory. */
static bool neighbours_among(struct nb_neighbour_pairs *pairs, struct nb_model *model, const struct nb_mesh *mesh,
                             const struct nb_mesh_item *it, int from, int to) {
  enum { BATCH = 64 };
  const double skin = model->search.skin;
  int slot[BATCH];
  double distance[BATCH];
  model->search.candidates += (unsigned long long)(to - from);
  for (; from < to; from += BATCH) {
    const int n = to - from < BATCH ? to - from : BATCH;
    int near = 0;
    for (int k = 0; k < n; k++) {
      const struct nb_mesh_item *other = &mesh->item[from + k];
      slot[near] = other->slot, distance[near] = vec_length(vec_sub(other->x, it->x));
      near += distance[near] < it->radius + other->radius + skin;
    }
    for (int k = 0; k < near; k++)
      if (counts_once(model, it->slot, slot[k]) &&
          !near_pair(pairs, model, nb_mesh_particle(it->slot), nb_mesh_particle(slot[k]), distance[k]))
        return false;
  }
  return true;
}

/* Tests each item against the later ones of its box and those of half the boxes around it, so each pair is tested once.
 * False: out of memory. */
static bool neighbours_in_mesh(struct nb_neighbour_pairs *pairs, struct nb_model *model, const struct nb_mesh *mesh) {
  for (size_t p = 0; p < mesh->count; p++) {
    const struct nb_mesh_item *it = &mesh->item[p];
    const int *start = mesh->start + it->box, *above = start + mesh->row;
    if (!neighbours_among(pairs, model, mesh, it, (int)p + 1, start[2]) ||
        !neighbours_among(pairs, model, mesh, it, above[-1], above[2]))
      return false;
  }
  return true;
}

/* Lists the pairs of particle i and a wall whose gap is smaller than the skin. False: out of memory. */
static bool neighbour_walls(struct nb_neighbour_pairs *pairs, struct nb_model *model, int i) {
  const struct nb_walls *walls = &model->walls;
  const struct nb_particles *particles = &model->particles;
  for (size_t w = 0; w < walls->count; w++) {
    if (nb_wall_removed(walls, w))
      continue;
    const double apart = vec_length(nb_wall_separation(walls, (int)w, particles->position[i]));
    if (!(apart < particles->radius[i] + model->search.skin) || !(particles->inverse_mass[i] > 0))
      continue;
    model->search.check_walls = model->search.check_walls || !(apart > model->search.skin);
    if (!pairs_add(pairs, i, (int)w,
                   material_pair_of(model, particles->material[i], model->scene->walls[w].material, true)))
      return false;
  }
  return true;
}

/* Lists the pairs of a particle with walls and, if there is no mesh, with other particles. False: out of memory. */
static bool neighbours_of(struct nb_neighbour_pairs *pairs, struct nb_model *model, const struct search *search,
                          int i) {
  const bool found = search->mesh.count ? true
                     : model->cell
                         ? neighbours_of_images(pairs, model, search, i)
                         : neighbours_around(pairs, model, search, (struct origin){i, model->particles.position[i]});
  return found && neighbour_walls(pairs, model, i);
}

/* Tests all pairs of a few particles, and all pairs of a particle and a wall. False: out of memory. */
static bool all_pairs(struct nb_neighbour_pairs *found, struct nb_model *model) {
  const int *slot = model->particles.slot, n = (int)model->particles.count;
  const struct nb_vec *x = model->particles.position;
  bool ok = true;
  for (int k = 0; k < n && ok; k++) {
    for (int l = k + 1; l < n && ok; l++)
      ok = neighbour_pair(found, model, slot[k], slot[l], vec_sub(x[slot[l]], x[slot[k]]));
    ok = ok && neighbour_walls(found, model, slot[k]);
  }
  return ok;
}

/* Finds every pair whose gap is smaller than the skin once, unsorted. False: out of memory. */
static bool find_pairs(struct nb_neighbour_pairs *found, struct nb_model *model) {
  const int n = (int)model->particles.count;
  if (!pairs_reserve(found, model->contacts.count + (size_t)n / 8 + 16))
    return false;
  if (n <= GRID_MIN_PARTICLES && !model->cell)
    return all_pairs(found, model);
  struct search search = {0};
  bool ok = search_begin(&search, model) && (!search.mesh.count || neighbours_in_mesh(found, model, &search.mesh));
  for (int k = 0; k < n && ok; k++)
    ok = neighbours_of(found, model, &search, model->particles.slot[k]);
  nb_mesh_free(&search.mesh);
  nb_grid_free(&search.grid);
  free(search.wrapped);
  return ok;
}

/* Sorts the pairs: by the number of the first particle with a counting sort, then the few pairs of each particle in the
 * order of force summation with an insertion sort. False: out of memory. */
static bool sort_pairs(struct nb_neighbour_pairs *pairs, const struct nb_model *model) {
  const size_t n = pairs->count, particles = model->particles.count;
  const int *number = model->particles.number;
  struct nb_neighbour_pair *found = pairs->list, *sorted = nb_array(n, sizeof *sorted);
  size_t *first = nb_array(particles + 2, sizeof *first);
  if (!sorted || !first) {
    free(sorted), free(first);
    return false;
  }
  for (size_t p = 0; p < n; p++)
    first[number[found[p].a] + 1]++;
  for (size_t k = 1; k < particles + 2; k++)
    first[k] += first[k - 1];
  for (size_t p = 0; p < n; p++)
    sorted[first[number[found[p].a]]++] = found[p];
  for (size_t p = 1; p < n; p++) {
    const struct nb_neighbour_pair it = sorted[p];
    size_t q = p;
    for (; q > 0 && sorted[q - 1].a == it.a && nb_partner_rank(model, it) < nb_partner_rank(model, sorted[q - 1]); q--)
      sorted[q] = sorted[q - 1];
    sorted[q] = it;
  }
  free(found), free(first);
  pairs->list = sorted;
  return true;
}

/* Sorts the pairs and makes the new list of contacts from them. False: out of memory. */
static bool renew_contacts(struct nb_model *model, struct nb_neighbour_pairs *pairs) {
  return (pairs->count == 0 || sort_pairs(pairs, model)) && nb_contacts_renew(model, pairs) && nb_vertices_find(model);
}

enum nb_status nb_neighbours_restore(struct nb_model *model, struct nb_store *store, struct nb_error *error) {
  struct nb_neighbour_pairs pairs = {0};
  store->restoring = true;
  nb_pairs_store(store, "contacts", &pairs, model);
  const bool made = !store->failed && renew_contacts(model, &pairs);
  free(pairs.list);
  if (store->failed)
    return nb_error_set(error, NB_BAD_USE, "the checkpoint has contacts that the page does not have");
  return made ? nb_blocks_create(model, error) : nb_error_memory(error);
}

enum nb_status nb_neighbours_search(struct nb_model *model, struct nb_error *error) {
  if (nb_guard_positions(model, error) || nb_walls_crossed(model, true, error) || nb_guard_motion(model, error))
    return error->status;
  struct nb_neighbour_pairs pairs = {0};
  const bool searching = model->search.skin < INFINITY;
  if (model->cell && nb_cell_check_width(model, error))
    return error->status;
  model->search.check_walls = model->search.check_pairs = false;
  model->search.too_deep.overlap = 0;
  const bool found = !searching || find_pairs(&pairs, model), too_deep = model->search.too_deep.overlap > 0;
  const bool made = found && !too_deep && renew_contacts(model, &pairs);
  free(pairs.list);
  if (!made)
    return found && too_deep ? nb_guard_pair(model, model->search.too_deep, error) : nb_error_memory(error);
  memcpy(model->particles.search_position, model->particles.position, model->particles.count * sizeof(struct nb_vec));
  nb_walls_reset_travel(&model->walls);
  if (model->cell)
    nb_cell_reset_travel(model->cell, model->search.skin);
  model->search.count += searching;
  model->search.last_cycle = model->cycle;
  return nb_blocks_create(model, error);
}

enum nb_status nb_neighbours_search_again(struct nb_model *model, struct nb_error *error) {
  model->search.keep_forces = true;
  const enum nb_status status = nb_neighbours_search(model, error);
  model->search.keep_forces = false;
  return status;
}
