// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// State hashes of every scene of the catalogue, small as in small_scenes.h, by each kind of step in the order of
// StepKind. Every build on every machine must give them, with any number of workers. Written by
// tests/determinism/renew.py.

#pragma once

#include <cstdint>

namespace determinism {

struct SceneHashes {
    const char* scene;
    uint64_t hashes[3];
};

inline constexpr int sceneSteps = 60;

inline constexpr SceneHashes sceneHashes[] = {
    {"tiles", {0x2bcb303c8c47dc9e, 0xefc86c54c6e67e24, 0x54da6d5a095d5b61}},
    {"add-pair-400", {0xbee7098995a91724, 0x90c6fd3aff1441de, 0x004a86a9f9ad4eb3}},
    {"falling-squares", {0x351033f26ac742f2, 0x01d6520a04903d41, 0x0824d182991f8db5}},
    {"falling-circles", {0x82161725c5fd7a14, 0x773f9e5085242288, 0x6f5d58bae21dfa32}},
    {"tumbler", {0x14fe03c9d5a99d33, 0x2a8e6a5dbf7a597c, 0x28d423802e5ce2d0}},
    {"multi-fixture", {0x54343246c333cfc6, 0x9cd04ad8db4af323, 0x657124490c89393a}},
    {"add-pair", {0xcee3b6981fb2cc26, 0xfd2783d163b60d3b, 0x70a56868b7513495}},
    {"mild-n2", {0x2245a3dcd870637b, 0xd7be2328e011bac0, 0x44b61d1448b802e6}},
    {"n2", {0xeb3a84d86cbeb46f, 0xc7b744c8cd318c88, 0x9d83257fd70174c0}},
    {"mostly-static-single", {0x0f9f1213655417d5, 0xe1ddc8599583e119, 0xc9e701d163893d99}},
    {"mostly-static-multi", {0x18996278ebd8eda3, 0x783c9544ec9463a9, 0x697f3220b2ab08ed}},
    {"diagonal", {0x9e7a2dc6f1d2d24d, 0x77d16a399075c6ef, 0xd6385243b70e5976}},
    {"mixed", {0xde9d974d18e94d31, 0x513b92b7f4b33b9d, 0xa7047b06e082262b}},
    {"slow-explosion", {0x7adde6bc8345c45f, 0x9e63c2066960f73b, 0x6a75fcf4abb29be3}},
    {"big-mobile", {0x462ed83f6c66a283, 0x394773b70cdf0d15, 0x223984dec3258f1a}},
    {"pyramid", {0x5572f3075d3e2089, 0x807a9a1644dfda34, 0x0edaa5eaa5b6bbd1}},
    {"box-stack", {0x56534f9633ff2939, 0xd4c9b9d21fb012df, 0xd9e11e71f09460d6}},
    {"domino-row", {0x177edc48745afb7b, 0x4ed9fe1586afaf06, 0x249cd650a34b787b}},
    {"bridge", {0x0adb90480f061bc3, 0x796e307f44f8bced, 0xe43a678994e2d745}},
    {"chain-heavy-end", {0xb67e5c7be122dd74, 0x7733f61d8b2b3c55, 0x15bed97d8a1bf2fc}},
    {"cantilever", {0xc078260d594aa4f3, 0x84cfed2ddc3ef5e4, 0x890c4b87bc724a29}},
    {"car", {0xf7eb6ff8e240538d, 0xe0e6362f7a373343, 0x99e9f921a89c3023}},
    {"ragdolls", {0xa180e44073a20494, 0x63860e7a338b2194, 0x49b8d5bd34ecb9c3}},
    {"conveyor", {0xda1c00b713ade11b, 0x14fccb5349217d07, 0xe4392cc3a73dfd79}},
    {"pulley", {0x76d1c1d39298044a, 0xad5c7ebd79c0828e, 0xa174c4b307b648bf}},
    {"gears", {0xbf2760a9bc3914f1, 0xa304a75a8125091c, 0xe1a42a84c1969248}},
    {"slider-crank", {0x6139246f31efff12, 0x9b50ddb73df3aa16, 0x246ed3dbf118c78a}},
    {"web", {0x703e682e32143aee, 0x8a8024ac4e8672d6, 0xe186657a35b6db7e}},
    {"character-corner-cases", {0x1ccdba586a4e136f, 0xdfbd4cc81b067f0b, 0x6b99060d17960695}},
    {"sensors", {0xd1e666a8adf07efb, 0x09a4d5917025fb6f, 0xecbe77aa4e9e7779}},
    {"ray-cast-playground", {0xf80daddc6d351def, 0xaf8e1cc38e2027b9, 0xfdf536f6bb319a93}},
    {"restitution-row", {0x1e42998a27c00cec, 0x47f068548d185f69, 0xb7afe5887a96c6ac}},
    {"friction-row", {0x2af052c5fb570bbd, 0xab1b9cb6db981160, 0xcada6be40209f686}},
    {"convex-shapes", {0x9f4ce1c43b300abb, 0x06fc905bb8b85181, 0xfc4e919a1cc775ec}},
    {"platformer", {0x814decc4de443064, 0x9a7f98b1479d45dd, 0x0326cf3b7b296dc4}},
    {"cars", {0x5d4f1a3fa72fc8fd, 0x0e67f0ec47f70a07, 0x11e15d7b73893463}},
    {"bin", {0xd8d98f9e6dff0595, 0x6db2cadf62fd701c, 0x49d4ef507daa5188}},
    {"bullets", {0xdd232206719cb803, 0x608bea39ae2bc15e, 0x33b743dcdb08f0af}},
    {"joint-distance", {0x7156920e776a8f43, 0x75b7c62ccd2e2009, 0x7331a1f3c6cad1e4}},
    {"joint-friction", {0xa4f9f622071a0f44, 0x09f73ae61b335ef3, 0xc6fdeaa2a2fe9ece}},
    {"joint-gear", {0x27bed45b6d584dd7, 0x9b5878e5d80886c3, 0x0aa38c4231784afd}},
    {"joint-motor", {0x87764c8f334f887d, 0x4def9e73b523c388, 0xe6c71769510b886a}},
    {"joint-mouse", {0xd111c4ecc621e4d5, 0xc6910e696ff270c0, 0xa342a6a4ee98e4ef}},
    {"joint-prismatic", {0xd3db339cdb66b244, 0xb747b382005d3e40, 0x946e347e5ed8c484}},
    {"joint-pulley", {0xcad183d81f3f1fc1, 0xfd9d905275c4e943, 0xa28283a48413aecf}},
    {"joint-revolute", {0x7ed832d23eef67cb, 0x77d7dd12703a900c, 0x2b602bf881e38161}},
    {"joint-weld", {0xebe1206cb338dc2f, 0x3682b48887e60b90, 0xa097e3283fdf05e5}},
    {"joint-wheel", {0xec80a76d03bc7c8a, 0xf0b4273fa30f0dfa, 0xce23b2ccc663d05e}},
    {"nets", {0xb613c1a99c7d2456, 0x92b7bd821df0e95b, 0xc286fe8cbe2f56c9}},
    {"bounces", {0xd4b5439c8e900d12, 0x4f843526ab105a8d, 0x0e39f32a09d91e0f}},
};

}  // namespace determinism
