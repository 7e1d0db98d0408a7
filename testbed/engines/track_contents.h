// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What a track that the testbed records has beyond motion and contacts.

#pragma once

namespace testbed {

struct TrackContents {
    bool tree = false;    ///< the nodes of the engine's tree after each step
    bool stages = false;  ///< the engine's times of each step
};

}  // namespace testbed
