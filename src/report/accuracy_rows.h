/* Relative errors by steps per collision; written by `make accuracy`, see docs/ACCURACY.md.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
/* clang-format off */
{2, 90, 0.0236, 0.132},
{4, 461, 0.0105, 0.989},
{8, 657, 0.0018, 0.124},
{16, 687, 0.000374, 0.0437},
{32, 828, 0.000194, 0.0144},
{64, 742, 6.69e-05, 0.00455},
{128, 645, 3.13e-05, 0.00139},
{256, 469, 7.49e-06, 0.000493},
{512, 398, 3.09e-06, 0.000495},
{1024, 375, 7.78e-07, 0.000273},
