#include "spatial/delaunay.h"
