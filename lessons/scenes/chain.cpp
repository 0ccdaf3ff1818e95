#include "lessons/scenes/chain.hpp"

namespace byhand {

template Scene<PlaneParticle, Distance> rod_chain(const ChainOptions&);
template Scene<PlaneParticle, NormalisedDistance> rod_chain(const ChainOptions&);
template Scene<PlaneBody, Distance> rod_chain(const ChainOptions&);
template Scene<PlaneBody, NormalisedDistance> rod_chain(const ChainOptions&);
template Scene<SpaceParticle, Distance> rod_chain(const ChainOptions&);
template Scene<SpaceParticle, NormalisedDistance> rod_chain(const ChainOptions&);
template Scene<SpaceBody, Distance> rod_chain(const ChainOptions&);
template Scene<SpaceBody, NormalisedDistance> rod_chain(const ChainOptions&);
template Scene<PlaneBody, Pin> pinned_chain(const ChainOptions&);
template Scene<SpaceBody, Pin> pinned_chain(const ChainOptions&);

}  // namespace byhand
