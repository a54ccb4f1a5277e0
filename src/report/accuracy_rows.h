/* Relative errors by steps per collision; written by `make accuracy`, see docs/ACCURACY.md.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
/* clang-format off */
{2, 164, 0.0317, 0.132},
{4, 422, 0.00158, 0.0241},
{8, 615, 0.00102, 0.0186},
{16, 604, 0.000234, 0.008},
{32, 598, 4.86e-05, 0.00373},
{64, 559, 8.11e-06, 0.00149},
{128, 433, 1.75e-06, 0.000613},
{256, 368, 1.88e-06, 0.000476},
{512, 284, 1.9e-06, 0.000324},
{1024, 198, 1.07e-06, 0.000256},
