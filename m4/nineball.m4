# What configure.ac needs beyond autoconf's own macros.
#
# Copyright (C) 2026 the nineball authors. GPL-3.0-or-later.

# NB_TRY_CFLAGS(VARIABLE, FLAGS): adds to VARIABLE each of FLAGS that the compiler takes without a complaint.
# -Werror, because clang only warns of a flag that it does not know.
AC_DEFUN([NB_TRY_CFLAGS], [
  for nb_flag in $2; do
    AC_MSG_CHECKING([whether $CC takes $nb_flag])
    nb_saved_CFLAGS=$CFLAGS
    CFLAGS="$CFLAGS -Werror $nb_flag"
    AC_COMPILE_IFELSE([AC_LANG_PROGRAM([], [])],
      [AC_MSG_RESULT([yes])
       $1="$$1 $nb_flag"],
      [AC_MSG_RESULT([no])])
    CFLAGS=$nb_saved_CFLAGS
  done
])
