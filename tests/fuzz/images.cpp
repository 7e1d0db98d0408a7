// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Damaged images whose checksum is right. Laws: a load ends with a world or an error; a world that was loaded can be
// stepped, saved and loaded again. The input is a list of edits to the image of a world with a bit of everything.

#include <cstring>
#include <memory>
#include <vector>

#include "scree/inspect.h"
#include "scree/scree.h"
#include "tests/fuzz/input.h"
#include "tests/fuzz/small_world.h"
#include "world/image.h"

namespace fuzz {
namespace {

/// Where the size and the checksum stand in front of an image, and how long that is.
constexpr size_t sizeAt = 16, checksumAt = 24, headerSize = 32;

void Seal(std::vector<std::byte>& image) {
    const uint64_t size = image.size();
    const uint64_t sum = scree::ChecksumOf(std::span<const std::byte>(image).subspan(headerSize));
    std::memcpy(image.data() + sizeAt, &size, sizeof size);
    std::memcpy(image.data() + checksumAt, &sum, sizeof sum);
}

void Damage(Input& input, std::vector<std::byte>& image) {
    constexpr int mostEdits = 8;
    for (int i = 0; i < mostEdits && !input.IsEmpty(); ++i) {
        const size_t offset = input.Word();
        const size_t at = headerSize + offset % (image.size() - headerSize);
        const int kind = input.Choose(8);
        if (kind == 0) {
            image.resize(std::max(headerSize + 1, at));
        } else if (kind == 1) {
            image.insert(image.begin() + static_cast<std::ptrdiff_t>(at), std::byte{input.Byte()});
        } else if (kind < 4 && at + sizeof(float) <= image.size()) {
            const float number = input.Number();
            std::memcpy(image.data() + at, &number, sizeof number);
        } else {
            image[at] = std::byte{input.Byte()};
        }
    }
}

void Check(const std::vector<std::byte>& image) {
    const std::unique_ptr<scree::World> world = scree::LoadWorld(image);
    if (world == nullptr) return;
    world->SetErrorHandler([](const scree::Error&, void*) {}, nullptr);
    for (int i = 0; i < 3; ++i) {
        i == 1 ? world->Step(1.0f / 60.0f, 8, 3) : world->Step(1.0f / 60.0f, 4);
    }
    const std::unique_ptr<scree::World> again = scree::LoadWorld(scree::SaveWorld(*world));
    Demand(again != nullptr, "what was loaded can be saved and loaded again");
    Demand(scree::inspect::GetStateHash(*again) == scree::inspect::GetStateHash(*world), "and is the same");
}

}  // namespace
}  // namespace fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    static const std::vector<std::byte> whole = scree::SaveWorld(*fuzz::MakeSmallWorld());
    fuzz::Input input(data, size);
    std::vector<std::byte> image = whole;
    fuzz::Damage(input, image);
    fuzz::Seal(image);
    fuzz::Check(image);
    return 0;
}
