/** What this library was built with: nothing of Boost (docs/moving-from-player.md), so that nothing is defined. */
#ifndef LIBPLAYERCPP_CONFIG_H
#define LIBPLAYERCPP_CONFIG_H

#endif /* LIBPLAYERCPP_CONFIG_H */
