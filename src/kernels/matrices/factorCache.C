// SPDX-License-Identifier: GPL-3.0-or-later

#include "factorCache.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::fsi::admmFactor& Foam::fsi::factorCache::get
(
    const scalar dt,
    const label nBoundary,
    const std::function<matrix(scalar)>& newMatrix
)
{
    auto found = std::find_if
    (
        factors_.begin(),
        factors_.end(),
        [dt](const auto& f) { return f->deltaT() == dt; }
    );
    if (found == factors_.end())
    {
        factors_.push_back
        (
            std::make_unique<admmFactor>(newMatrix(dt), nBoundary, dt)
        );
        ++nMade_;
        found = std::prev(factors_.end());
    }

    std::rotate(factors_.begin(), found, std::next(found));
    if (factors_.size() > nKept)
    {
        factors_.pop_back();
    }
    return *factors_.front();
}


// ************************************************************************* //
