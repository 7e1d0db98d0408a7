// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// Implementation of byte_stream.h.

#include "testbed/jobs/timeline/byte_stream.h"

#include <zlib.h>

#include "testbed/base/errors.h"
#include "testbed/page/page_markup.h"

namespace testbed {

std::string ByteStream::Pack() const {
    uLongf size = compressBound(static_cast<uLong>(m_bytes.size()));
    std::vector<unsigned char> packed(size);
    // Level 9 takes four times as long and saves some percent.
    if (compress2(packed.data(), &size, m_bytes.data(), static_cast<uLong>(m_bytes.size()), 6) != Z_OK) {
        throw FileError("out of memory while packing a page");
    }
    packed.resize(size);
    return EncodeBase64(packed);
}

}  // namespace testbed
