// SPDX-License-Identifier: GPL-3.0-or-later

#include "poissonCases.H"
#include "mathematicalConstants.H"
#include <random>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::string Foam::fsi::referenceControls()
{
    return
        "solver PCG; preconditioner DIC; tolerance 1e-12; relTol 0;"
        " maxIter 5000;";
}


std::function<Foam::label(const Foam::labelVector&)> Foam::fsi::halves
(
    const direction d,
    const label n
)
{
    const label nRanks = Pstream::nProcs();
    return [=](const labelVector& c) { return c[d]*nRanks/n; };
}


void Foam::fsi::forPatchCombinations
(
    const labelVector& n,
    const label nDims,
    const std::function
    <
        void(latticeMesh&, const wordList&, const std::string&)
    >& test
)
{
    static const char* const kinds[] =
    {
        "gradient", "lowFixed", "bothFixed", "highFixed", "cyclic"
    };
    static const char* const axes[] = {"x", "y", "z"};
    label nCombinations = 1;
    for (label d = 0; d < nDims; ++d)
    {
        nCombinations *= 5;
    }

    // On several ranks some that have every kind in every direction
    const label step = !Pstream::parRun() ? 1 : nDims == 2 ? 8 : 31;
    for
    (
        label combination = 0;
        combination < nCombinations;
        combination += step
    )
    {
        latticeOptions options;
        options.n = n;
        options.emptyDirection = nDims == 2 ? 2 : 3;
        options.spacing = vector(1, 1.3, 0.8);
        wordList fixed;
        std::string name;
        label rest = combination;
        for (label d = 0; d < nDims; ++d)
        {
            const label kind = rest % 5;
            rest /= 5;
            options.cyclic[d] = kind == 4;
            name += std::string(axes[d]) + ' ' + kinds[kind] + ' ';
            if (kind == 1 || kind == 2)
            {
                fixed.append(word(axes[d]) + "Min");
            }
            if (kind == 2 || kind == 3)
            {
                fixed.append(word(axes[d]) + "Max");
            }
        }
        latticeMesh mesh(options);
        test(mesh, fixed, name);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::discs::discs(const label nRow)
:
    nRow_(nRow),
    radius_(std::sqrt(0.41/constant::mathematical::pi)/max(nRow, label(1))),
    centres_(nRow*nRow)
{
    std::mt19937 generator(5);
    std::uniform_real_distribution<scalar> jitter(-1, 1);
    forAll(centres_, i)
    {
        const scalar room = 0.5/nRow - radius_;
        const scalar x = (i % nRow + 0.5)/nRow;
        const scalar y = (i/nRow + 0.5)/nRow;
        const scalar dx = room*jitter(generator);
        centres_[i] = point(x + dx, y + room*jitter(generator), 0);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::discs::distance(const scalar x, const scalar y) const
{
    scalar nearest = GREAT;
    const label i = label(x*nRow_);
    const label j = label(y*nRow_);
    for (label b = max(j - 1, label(0)); b <= min(j + 1, nRow_ - 1); ++b)
    {
        for (label a = max(i - 1, label(0)); a <= min(i + 1, nRow_ - 1); ++a)
        {
            const point& centre = centres_[a + nRow_*b];
            nearest =
                min(nearest, std::hypot(x - centre.x(), y - centre.y()));
        }
    }
    return nearest - radius_;
}


Foam::scalar Foam::fsi::discs::open
(
    const scalar x0,
    const scalar y0,
    const scalar x1,
    const scalar y1
) const
{
    const scalar a = distance(x0, y0);
    const scalar b = distance(x1, y1);
    if ((a > 0) == (b > 0))
    {
        return a > 0 ? 1 : 0;
    }
    return max(a, b)/(max(a, b) - min(a, b));
}


void Foam::fsi::maskByDiscs
(
    poissonProblem& problem,
    const label n,
    const label nRow,
    const bool voxel
)
{
    const scalar h = 1.0/n;
    const discs walls(nRow);
    const auto solid = [&](const labelVector& c)
    {
        return walls.distance((c.x() + 0.5)*h, (c.y() + 0.5)*h) <= 0;
    };
    const auto open = [&](const labelVector& c, const direction d)
    {
        return walls.open
        (
            c.x()*h, c.y()*h, (c.x() + (d == 1))*h, (c.y() + (d == 0))*h
        );
    };
    problem.mask
    (
        solid,
        voxel
      ? std::function<scalar(const labelVector&, direction)>()
      : open
    );
}


// ************************************************************************* //
