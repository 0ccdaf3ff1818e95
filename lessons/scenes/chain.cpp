#include "lessons/scenes/chain.hpp"

namespace byhand {

template Scene<PlaneParticle> rod_chain<PlaneParticle, Distance>(const ChainOptions&);
template Scene<PlaneParticle> rod_chain<PlaneParticle, NormalisedDistance>(const ChainOptions&);
template Scene<PlaneBody> rod_chain<PlaneBody, Distance>(const ChainOptions&);
template Scene<PlaneBody> rod_chain<PlaneBody, NormalisedDistance>(const ChainOptions&);
template Scene<SpaceParticle> rod_chain<SpaceParticle, Distance>(const ChainOptions&);
template Scene<SpaceParticle> rod_chain<SpaceParticle, NormalisedDistance>(const ChainOptions&);
template Scene<SpaceBody> rod_chain<SpaceBody, Distance>(const ChainOptions&);
template Scene<SpaceBody> rod_chain<SpaceBody, NormalisedDistance>(const ChainOptions&);
template Scene<PlaneBody> pinned_chain<PlaneBody>(const ChainOptions&);
template Scene<SpaceBody> pinned_chain<SpaceBody>(const ChainOptions&);

}  // namespace byhand
