/// What many tests include, for PLAYHOUSE_PRECOMPILE.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "library.h"
