// SPDX-License-Identifier: Apache-2.0
// One of many, taken in proportion to its weight in one pass over them (Chao 1982), with one random number for all.
#ifndef UTSURI_LIB_RESERVOIR
#define UTSURI_LIB_RESERVOIR

struct Reservoir {
    float remaining;  ///< random number in [0, 1), used up bit by bit
    float sum;        ///< of all weights so far
    float taken;      ///< weight of the one that is taken; 0 while there is none
};

Reservoir empty_reservoir(float u) {
    return Reservoir(u, 0.0, 0.0);
}

/// Whether the next one replaces what was taken before; one whose weight is not above 0 never does.
bool takes(inout Reservoir reservoir, float weight) {
    if (!(weight > 0.0)) return false;
    reservoir.sum += weight;
    float probability = weight / reservoir.sum;
    if (reservoir.remaining < probability) {
        reservoir.remaining /= probability;
        reservoir.taken = weight;
        return true;
    }
    reservoir.remaining = (reservoir.remaining - probability) / (1.0 - probability);
    return false;
}

#endif
