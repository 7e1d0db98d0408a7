// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// The references themselves: they are complete, small, and every two of them are told apart by the comparison.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <vector>

#include "scenes/catalog.h"
#include "testbed/jobs/snapshot/catalog.h"
#include "testbed/jobs/snapshot/reference_folder.h"
#include "testbed/picture/image_compare.h"

namespace testbed {
namespace {

namespace fs = std::filesystem;

const fs::path references = SCREE_REFERENCE_FOLDER;

TEST(SnapshotCatalog, ShowsEverySceneAtTwoStepsAndEachLayerInManyScenes) {
    std::map<std::string, std::set<int>> steps;
    std::map<std::string, std::set<std::string>> scenesOf;
    std::set<std::string> ids;
    for (const SnapshotCase& snapshotCase : GetSnapshotCatalog()) {
        steps[snapshotCase.scene].insert(snapshotCase.step);
        scenesOf[snapshotCase.layers].insert(snapshotCase.scene);
        EXPECT_TRUE(ids.insert(snapshotCase.GetId()).second) << snapshotCase.GetId() << " is listed twice";
        const scenes::SceneInfo* info = scenes::Find(snapshotCase.scene);
        ASSERT_NE(info, nullptr);
        EXPECT_GE(snapshotCase.size, info->minSize);
        EXPECT_LE(snapshotCase.size, info->defaultSize);
    }
    for (const scenes::SceneInfo& info : scenes::Catalog()) {
        EXPECT_EQ(steps[std::string(info.name)].size(), 2u) << info.name;
    }
    // A third of the scenes each, as far as a hash of their names shares them out.
    for (const auto& [layers, names] : scenesOf) EXPECT_GE(names.size(), scenes::Catalog().size() / 5) << layers;
}

TEST(SnapshotReferences, AreSmall) {
    std::uintmax_t total = 0;
    for (const std::string& id : ListReferences(references)) {
        const std::uintmax_t picture = fs::file_size(references / (id + ".png"));
        EXPECT_LT(picture, 30'000u) << id;
        total += picture + fs::file_size(references / (id + ".json"));
        const Reference reference = ReadReference(references, id);
        EXPECT_LE(reference.image.width, 640) << id;
        EXPECT_LE(reference.image.height, 400) << id;
    }
    EXPECT_LT(total, 9'500u * GetSnapshotCatalog().size());
}

/// The first row in which two pictures of one size differ as a picture of its own, of `image`; the last if none does.
Image FirstOtherRow(const Image& image, const Image& other) {
    const auto firstOther = std::ranges::mismatch(image.pixels, other.pixels).in1 - image.pixels.begin();
    const int y = std::min(static_cast<int>(firstOther) / image.width, image.height - 1);
    Image row(image.width, 1, {});
    std::copy_n(&image.At(0, y), image.width, row.pixels.begin());
    return row;
}

// A comparison that cannot fail is worthless: each reference must fail against each other one. It fails as soon as one
// row does, and all rows of 35,000 pairs would take half a minute.
TEST(SnapshotReferences, EveryPairOfThemDiffers) {
    const std::set<std::string> ids = ListReferences(references);
    std::map<std::string, SnapshotCase> cases;
    for (const SnapshotCase& one : GetSnapshotCatalog()) cases[one.GetId()] = one;
    // What stands still looks alike however it is run.
    const auto mayBeAlike = [&](const std::string& a, const std::string& b) {
        return cases.at(a).scene == cases.at(b).scene && cases.at(a).settings != cases.at(b).settings;
    };
    std::vector<Image> images;
    for (const std::string& id : ids) images.push_back(ReadReference(references, id).image);
    ASSERT_EQ(images.size(), GetSnapshotCatalog().size());
    for (std::size_t i = 0; i < images.size(); ++i) {
        EXPECT_EQ(ComparePixels(images[i], images[i], {}).changed, 0);
        for (std::size_t j = i + 1; j < images.size(); ++j) {
            ASSERT_EQ(images[i].pixels.size(), images[j].pixels.size());
            ASSERT_EQ(images[i].width, images[j].width);
            const Image rowI = FirstOtherRow(images[i], images[j]), rowJ = FirstOtherRow(images[j], images[i]);
            const std::string& a = *std::next(ids.begin(), static_cast<std::ptrdiff_t>(i));
            const std::string& b = *std::next(ids.begin(), static_cast<std::ptrdiff_t>(j));
            if (mayBeAlike(a, b)) continue;
            ASSERT_GT(ComparePixels(rowI, rowJ, {}).changed, 0) << a << " and " << b << " are one picture";
        }
    }
}

}  // namespace
}  // namespace testbed
