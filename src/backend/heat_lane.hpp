#pragma once
#include <cmath>

#include "backend/backend.hpp"
#include "backend/node_set.hpp"
