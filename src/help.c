/* The language of pages, from the tables that read it: statements, quantities, units.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#include "commands.h"
#include "reader.h"

static void statements(FILE *out, unsigned where, const char *title) {
  fprintf(out, "%s\n\n", title);
  for (const struct nb_keyword *keyword = nb_keywords(); keyword->apply; keyword++) {
    if (!(keyword->where & where))
      continue;
    char syntax[512];
    nb_keyword_syntax(syntax, sizeof syntax, keyword);
    fprintf(out, "  %s\n      %s\n", syntax, keyword->help);
  }
  fputc('\n', out);
}

void nb_help_language(FILE *out) {
  fputs("A page is Markdown; its blocks `scene`, `expect` and `gnuplot` are read, the rest is prose. One statement a "
        "line, # begins a "
        "comment.\n\n",
        out);
  statements(out, NB_IN_SCENE, "The scene");
  statements(out, NB_IN_STAGE, "In a stage");
  fputs("Quantities: WATCH.NAME for what is watched, the name alone for the scene\n\n", out);
  const char *name, *unit, *of, *help;
  for (size_t row = 0; nb_quantity_row(row, &name, &unit, &of, &help); row++)
    fprintf(out, "  %-16s %-6s of %-10s %s\n", name, unit, of, help);
  fputs("\nUnits\n\n", out);
  for (int kind = 0; kind < NB_UNIT_KINDS; kind++) {
    char list[256];
    nb_unit_list(list, sizeof list, (enum nb_unit_kind)kind);
    fprintf(out, "  %-26s %s\n", nb_unit_kind_name((enum nb_unit_kind)kind),
            kind == NB_UNIT_NUMBER ? "bare, or with % or ppm" : list);
  }
  fputs("\nExpectations: MEASURE is QUANTITY {max|min|mean|last|amplitude|frequency|at N cycles|at TIME} {in STAGE}\n\n"
        "  reference NAME\n"
        "  MEASURE within TOLERANCE                 of what the reference knows: 0.1 %, 2 nm, 1e-12\n"
        "  QUANTITY along COLUMN {in STAGE} within TOLERANCE         a curve; also `0.5 % of peak`\n"
        "  MEASURE stated NUMBER {UNIT} {of MEASURE} within TOLERANCE [SOURCE]\n"
        "  MEASURE below MEASURE, MEASURE above MEASURE\n"
        "  MEASURE rises with NAME, falls with NAME, same over NAME within TOLERANCE       NAME of a sweep\n",
        out);
}
