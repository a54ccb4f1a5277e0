/* Relative errors by steps per collision; written by `make accuracy`, see docs/ACCURACY.md.
 *
 * Copyright (C) 2026 the nineball authors. GPL-3.0-or-later. */
/* clang-format off */
{4, 71, 0.24, 1.7},
{8, 77, 0.061, 0.65},
{16, 79, 0.022, 0.4},
{32, 135, 0.011, 0.23},
{64, 139, 0.0051, 0.089},
{128, 135, 0.0027, 0.063},
{256, 131, 0.0014, 0.029},
{512, 128, 0.00074, 0.015},
{1024, 126, 0.00036, 0.008},
