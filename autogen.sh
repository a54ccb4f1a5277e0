#!/bin/sh
# Makes configure and Makefile.in. ./setup calls this script.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.
set -e
cd "$(dirname "$0")"
exec autoreconf -fi
