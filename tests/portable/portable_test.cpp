// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The program that compares hashes of the plain loops is really linked with them.

#include <gtest/gtest.h>

#include "constraints/contact_block.h"

namespace scree {
namespace {

TEST(Portable, TheEngineOfThisProgramUsesNoVectorInstructions) { EXPECT_STREQ(GetContactKernels().name, "portable"); }

}  // namespace
}  // namespace scree
