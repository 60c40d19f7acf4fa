// What the plugin uses of LIGGGHTS beyond what a single law does. SPDX-License-Identifier: GPL-2.0-or-later
#ifndef GRANLAW_HOST_HPP
#define GRANLAW_HOST_HPP

#include <mpi.h>
#include "fix_insert_stream.h"  // must come before granular_styles.h
#include "granular_styles.h"
#include "fix_rigid.h"
#include "fix_wall_gran.h"
#include "universe.h"
#include "adapter.hpp"

#endif
