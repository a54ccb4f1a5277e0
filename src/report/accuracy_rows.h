/* Relative errors by steps per collision; written by `make accuracy`, see docs/ACCURACY.md.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
/* clang-format off */
{2, 85, 0.0236, 0.132},
{4, 468, 0.0103, 0.982},
{8, 684, 0.0018, 0.111},
{16, 729, 0.000391, 0.0367},
{32, 880, 0.000209, 0.0144},
{64, 796, 7.37e-05, 0.00385},
{128, 687, 3.42e-05, 0.00135},
{256, 502, 7.73e-06, 0.000603},
{512, 419, 3.09e-06, 0.000495},
{1024, 384, 7.55e-07, 0.000273},
