// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Eight pairs of shapes side by side, as the vector kernels read and write them: small polygons, one and a disk, round
// shapes whose cores are segments or small polygons. Plain data only, because translation units for different
// instruction sets share it.

#pragma once

#include <cstdint>

namespace scree {

inline constexpr int quadLanes = 8;

/// The polygons of one side, [corner][lane]. Corners beyond a polygon's number repeat the first. A segment has two
/// corners and two faces, which look away from each other.
struct alignas(32) QuadShapes {
    using Row = float[quadLanes];
    Row vertexX[4], vertexY[4], normalX[4], normalY[4];
    Row last;  ///< number of corners − 1
};

struct alignas(32) QuadPairs {
    using Row = float[quadLanes];
    QuadShapes a, b;
    const float* placedA[quadLanes];  ///< Transform: x, y, sine, cosine
    const float* placedB[quadLanes];
    Row radius;      ///< of both skins together, m
    Row preference;  ///< by how much B's face must be better to be the reference, m
};

/// What was found; bit l of a mask is lane l.
struct alignas(32) QuadContacts {
    using Row = float[quadLanes];
    Row face, faceNext, incident, incidentNext;  ///< corner numbers
    Row localNormalX, localNormalY;              ///< of the reference face
    Row localPointX, localPointY;                ///< its middle
    Row pointX[2], pointY[2];                    ///< in the incident polygon's frame
    uint32_t touching;                           ///< the rest counts for these lanes only
    uint32_t isCorners;                          ///< of round shapes: the corners `face` and `incident` touch…
    uint32_t isPoint;                            ///< …or points do along a normal in A's frame
    uint32_t flipped;                            ///< the reference face is B's
    uint32_t isCut[2];                           ///< the clip against the reference face's first, second end cut…
    uint32_t hasMoved[2];                        ///< …its first point off, so that the second became the first
    uint32_t keeps[2];                           ///< the point lies within the skins
};

/// Polygons with three or four corners, and disks.
struct alignas(32) QuadDiskPairs {
    using Row = float[quadLanes];
    QuadShapes a;
    const float* placedA[quadLanes];  ///< Transform: x, y, sine, cosine
    const float* placedB[quadLanes];
    Row centreX, centreY;  ///< of the disk, in its body's frame
    Row radius;            ///< of the disk and the polygon's skin together, m
};

/// What was found; bit l of a mask is lane l.
struct alignas(32) QuadDiskContacts {
    using Row = float[quadLanes];
    Row localNormalX, localNormalY;  ///< in the polygon's frame, toward the disk
    Row localPointX, localPointY;    ///< middle of the face, or the corner, that touches
    uint32_t touching;               ///< the rest counts for these lanes only
};

/// The kernels of one instruction set. All sets give the same bits.
struct QuadKernels {
    void (*collideQuads)(const QuadPairs& pairs, QuadContacts& contacts);
    void (*collideQuadDisks)(const QuadDiskPairs& pairs, QuadDiskContacts& contacts);
    /// Cores with any radius, [A][B]: 0 segments, 1 polygons.
    void (*collideCores[2][2])(const QuadPairs& pairs, QuadContacts& contacts);
};

/// The best this processor has, and those that every processor has.
QuadKernels GetQuadKernels();
QuadKernels GetBaseQuadKernels();

}  // namespace scree
