/* Relative errors by steps per collision; written by `make accuracy`, see docs/ACCURACY.md.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
/* clang-format off */
{2, 112, 0.0317, 0.154},
{4, 363, 0.00197, 0.0342},
{8, 565, 0.000843, 0.0193},
{16, 598, 0.000234, 0.00883},
{32, 615, 5.6e-05, 0.00373},
{64, 529, 1.25e-05, 0.0018},
{128, 429, 1.02e-05, 0.000868},
{256, 372, 4.14e-06, 0.000493},
{512, 290, 2.04e-06, 0.000413},
{1024, 254, 4.61e-07, 0.0002},
