#include "io/error.h"
