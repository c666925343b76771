// SPDX-License-Identifier: MIT
// A wider network that computes what a narrower one does.
#ifndef SINEW_TRAINER_NETWORK_WIDEN_HPP
#define SINEW_TRAINER_NETWORK_WIDEN_HPP

#include <string>

#include "sinew_formats/float_network.hpp"

namespace sinew {

// The same architecture with as many channels in hidden buffers or more, and the same inputs and outputs.
bool is_wider(const FloatNetwork& wide, const FloatNetwork& narrow);

// Puts the narrow network's weights into the wide one, which then computes the same: added channels keep the weights that they are
// made of (random ones) and are read with zeros by the others, as in growing networks (Chen, Goodfellow, Shlens 2016, "Net2Net", with
// random channels in the place of copies: they differ from the start). Throws Error unless is_wider().
//   source  begins the message: the narrow network's file
void widen(const FloatNetwork& narrow, const std::string& source, FloatNetwork* wide);

}  // namespace sinew
#endif
