# Installed by the package step; see docs/ for how an outside program uses it.
