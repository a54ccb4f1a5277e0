/* Relative errors by steps per collision; written by `make accuracy`, see docs/ACCURACY.md.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
/* clang-format off */
{2, 106, 0.023, 0.132},
{4, 604, 0.0146, 1.06},
{8, 906, 0.00217, 0.18},
{16, 959, 0.000511, 0.0548},
{32, 1142, 0.000261, 0.0245},
{64, 1155, 8.5e-05, 0.0091},
{128, 1051, 2.97e-05, 0.00585},
{256, 939, 1.78e-05, 0.00364},
{512, 768, 7.56e-06, 0.00212},
{1024, 689, 5.57e-06, 0.00103},
