#pragma once
/// What every program of this folder defines: one try. libFuzzer invents the bytes, or replay.cpp reads them.

#include <cstddef>
#include <cstdint>

/// Always 0. Only what a reader promises to throw is caught: anything else, a signal, a leak or an endless loop is a
/// find.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
