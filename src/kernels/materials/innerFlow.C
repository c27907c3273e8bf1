// SPDX-License-Identifier: GPL-3.0-or-later

#include "innerFlow.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{
namespace innerFlow
{

//- lambda/mu
static const scalar bulkRatio = 100;

typedef Eigen::Ref<const Eigen::MatrixXd> constNodes;


//- The mean divergence around each node as a linear form of the velocities
struct nodalDivergence
{
    //- V_i [m^2]
    scalarField areas;

    //- Unknowns of each form and V_i times their coefficients [m]
    std::vector<std::vector<std::pair<label, scalar>>> forms;

    nodalDivergence(const List<bodyElement>& triangles, const constNodes& x)
    :
        areas(x.rows(), Zero),
        forms(x.rows())
    {
        scalar g[3][2];
        for (const bodyElement& e : triangles)
        {
            const scalar area = gradients(e, x, g);
            for (int i = 0; i < 3; ++i)
            {
                areas[e[i]] += area/3;
                for (int j = 0; j < 6; ++j)
                {
                    add
                    (
                        e[i],
                        e[j/2] + x.rows()*(j % 2),
                        g[j/2][j % 2]/6
                    );
                }
            }
        }
    }

    //- Add to a coefficient
    void add(const label node, const label unknown, const scalar value)
    {
        for (auto& term : forms[node])
        {
            if (term.first == unknown)
            {
                term.second += value;
                return;
            }
        }
        forms[node].emplace_back(unknown, value);
    }
};


//- Add the nodal part of the viscosity
static void addBulk
(
    const List<bodyElement>& triangles,
    const constNodes& x,
    const scalar bulk,
    std::vector<Eigen::Triplet<double>>& entries
)
{
    const nodalDivergence divergence(triangles, x);
    forAll(divergence.areas, nodei)
    {
        const auto& form = divergence.forms[nodei];
        for (const auto& a : form)
        {
            const scalar scaled = bulk*a.second/divergence.areas[nodei];
            for (const auto& b : form)
            {
                entries.emplace_back(a.first, b.first, scaled*b.second);
            }
        }
    }
}

} // End namespace innerFlow
} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::fsi::innerFlow::gradients
(
    const bodyElement& e,
    const Eigen::Ref<const Eigen::MatrixXd>& x,
    scalar g[3][2]
)
{
    for (int i = 0; i < 3; ++i)
    {
        const label b = e[(i + 1) % 3], c = e[(i + 2) % 3];
        g[i][0] = x(b, 1) - x(c, 1);
        g[i][1] = x(c, 0) - x(b, 0);
    }
    return 0.5*(g[1][0]*g[2][1] - g[1][1]*g[2][0]);
}


void Foam::fsi::innerFlow::addViscosity
(
    const List<bodyElement>& triangles,
    const Eigen::Ref<const Eigen::MatrixXd>& x,
    const scalar viscosity,
    const scalar factor,
    std::vector<Eigen::Triplet<double>>& entries
)
{
    const label n = x.rows();
    scalar g[3][2];
    for (const bodyElement& e : triangles)
    {
        // 2 mu A e:e, gradients being g/(2 A)
        const scalar weight = factor*viscosity/(4*gradients(e, x, g));
        for (int a = 0; a < 3; ++a)
        {
            for (int b = 0; b < 3; ++b)
            {
                const scalar dot = g[a][0]*g[b][0] + g[a][1]*g[b][1];
                for (int i = 0; i < 2; ++i)
                {
                    for (int j = 0; j < 2; ++j)
                    {
                        entries.emplace_back
                        (
                            e[a] + n*i,
                            e[b] + n*j,
                            weight*(g[a][j]*g[b][i] + (i == j ? dot : 0))
                        );
                    }
                }
            }
        }
    }
    addBulk(triangles, x, factor*bulkRatio*viscosity, entries);
}


Foam::scalar Foam::fsi::innerFlow::dissipation
(
    const List<bodyElement>& triangles,
    const Eigen::Ref<const Eigen::MatrixXd>& x,
    const Eigen::Ref<const Eigen::MatrixXd>& v,
    const scalar viscosity
)
{
    std::vector<Eigen::Triplet<double>> entries;
    addViscosity(triangles, x, viscosity, 1, entries);
    const label n = x.rows();
    scalar power = 0;
    for (const auto& entry : entries)
    {
        power += entry.value()
           *v(entry.row() % n, entry.row()/n)
           *v(entry.col() % n, entry.col()/n);
    }
    return power;
}


Foam::scalar Foam::fsi::innerFlow::quality
(
    const List<bodyElement>& triangles,
    const Eigen::Ref<const Eigen::MatrixXd>& x
)
{
    scalar least = 1;
    scalar g[3][2];
    for (const bodyElement& e : triangles)
    {
        const scalar area = gradients(e, x, g);
        scalar squares = 0;
        for (int i = 0; i < 3; ++i)
        {
            squares += g[i][0]*g[i][0] + g[i][1]*g[i][1];
        }
        least = min(least, 4*std::sqrt(3.0)*area/squares);
    }
    return least;
}


// ************************************************************************* //
