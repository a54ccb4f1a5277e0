/* The report: a static site with the text, figure and checks of each page.
 *
 *   index.html          pages that failed, the text of the first page if it is a document, search, all pages
 *   NAME/index.html     a page: text, figure, checks, cost, files
 *   files/              figures and text files to which the pages link
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
#pragma once

#include "commands.h"

/* A page of the report. */
struct nb_report_page {
  const char *path; /* the path that the caller gives */
  /* the real path of the page; owned; NULL: the page cannot be read */
  char *real;
  char name[NB_NAME_SIZE], title[NB_NAME_SIZE * 2]; /* `name` is unique in the report; `title` is the first heading */
  char message[512];                                /* an error other than a failed check, or empty */
  char figure[NB_NAME_SIZE + 8];                    /* NAME.svg, or NAME.png; used if `drawn` */
  char cost[256];                                   /* one line, or empty */
  char *dropped;                                    /* names of large files that were removed; owned */
  struct nb_outcome outcome;                        /* without its runs, once the page has been run */
  bool document;                                    /* the page has no block of the page language */
  bool unrun;                                       /* the page is shown without its results */
  bool saved, drawn;                                /* the page has tables; the page has a figure */
  double seconds;
};

struct nb_report {
  const char *folder;
  struct nb_report_page *pages;
  size_t count;
  bool trust; /* copy linked texts and pictures also from other folders, and hidden ones */
  struct nb_report_file {
    char *real, *name; /* the real path of the file; its name in the folder `files`; both owned */
  } * files;
  size_t file_count;
};

/* ---- html.c ---- */

/* Writes an escaped text between two pieces of HTML. */
void nb_html_text(FILE *out, const char *before, const char *text, const char *after);
/* Appends a file name as a part of a URL, percent-encoded (RFC 3986). */
void nb_html_address(char *address, size_t size, const char *name);
/* Writes everything up to the body. `top` is the path to the folder of the report: "" or "../". `script` is a script in
 * this folder, or NULL. */
void nb_html_begin(FILE *out, const char *title, const char *top, const char *script);
/* Writes "12 checks passed", or the failure; returns the class pass, fail or none. The text is empty for a document. */
const char *nb_html_verdict(char *text, size_t size, const struct nb_report_page *page);
void nb_html_checks(FILE *out, const struct nb_outcome *outcome);

/* ---- links.c ---- */

/* Returns lines TARGET<tab>ADDRESS<tab>CLASS<tab>VERDICT for the links of a page to other pages of the report and to
 * files, which are copied. `verdicts`: with the verdicts on these pages. The caller frees the text; NULL: out of
 * memory. */
char *nb_report_links(struct nb_report *report, const struct nb_report_page *page, const char *top, bool verdicts);

/* ---- convert.c ---- */

/* Writes the text of the page as HTML, with the table of checks in the place of the expect block or at the end.
 * Messages of pandoc go to stderr. NB_BAD_USE if pandoc cannot be run or refuses the page. */
enum nb_status nb_report_convert(FILE *out, struct nb_report *report, const struct nb_report_page *page,
                                 const char *top, bool verdicts, struct nb_error *error);
