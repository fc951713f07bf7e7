#include "spatial/hilbert.h"
