// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The export mark of Box2D 2.4: programs may write it on their own declarations. Nothing here needs it.

#pragma once

#define B2_API
