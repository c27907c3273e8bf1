// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyGroup.H"
#include "elementEnergy.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::fsi::bodyGroup::massAverage
(
    const Eigen::MatrixXd& values,
    const label copyi
) const
{
    vector sum(Zero);
    for (label i = 0; i < shape_.nDims(); ++i)
    {
        const auto column = values.col(shape_.nDims()*copyi + i);
        forAll(shape_.nodeMasses(), nodei)
        {
            sum[i] += shape_.nodeMasses()[nodei]*column[nodei];
        }
    }
    return sum/Foam::sum(shape_.nodeMasses());
}


Foam::scalar Foam::fsi::bodyGroup::springLength
(
    const label springi,
    const label copyi
) const
{
    const edge& ends = shape_.springs()[springi];
    scalar squares = 0;
    for (label i = 0; i < shape_.nDims(); ++i)
    {
        const auto x = positions_.col(shape_.nDims()*copyi + i);
        squares += sqr(x[ends.second()] - x[ends.first()]);
    }
    return std::sqrt(squares);
}


void Foam::fsi::bodyGroup::addElementTerms
(
    const label copyi,
    scalar& energy,
    Eigen::MatrixXd* force
) const
{
    if (shape_.membrane())
    {
        const auto x = positions_.middleCols(2*copyi, 2);
        energy += shape_.bending().energy(x);
        if (force)
        {
            shape_.bending().addForce(x, force->middleCols(2*copyi, 2));
        }
        return;
    }

    energy += addElementEnergy(shape_, positions_, copyi, force);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::bodyGroup::internalForce(Eigen::MatrixXd& force) const
{
    force.setZero(positions_.rows(), positions_.cols());

    for (label copyi = 0; copyi < size(); ++copyi)
    {
        auto x = positions_.middleCols(2*copyi, 2);
        auto f = force.middleCols(2*copyi, 2);

        forAll(shape_.springs(), springi)
        {
            const edge& ends = shape_.springs()[springi];
            const scalar state =
                springStates_.size() ? springStates_(springi, copyi) : 0;
            const scalar relaxed = shape_.law().relaxedLength
            (
                shape_.restLengths()[springi],
                state
            );
            const scalar length = springLength(springi, copyi);
            const scalar pull =
                shape_.springConstants()[springi]*(1 - relaxed/length);
            for (label i = 0; i < 2; ++i)
            {
                const scalar part =
                    pull*(x(ends.second(), i) - x(ends.first(), i));
                f(ends.first(), i) += part;
                f(ends.second(), i) -= part;
            }
        }

        scalar energy = 0;
        addElementTerms(copyi, energy, &force);
    }
}


Foam::scalar Foam::fsi::bodyGroup::kineticEnergy() const
{
    const Eigen::Map<const Eigen::VectorXd> masses
    (
        shape_.nodeMasses().cdata(),
        shape_.nNodes()
    );
    return 0.5*masses.dot(velocities_.rowwise().squaredNorm());
}


Foam::scalar Foam::fsi::bodyGroup::elasticEnergy() const
{
    scalar energy = 0;
    for (label copyi = 0; copyi < size(); ++copyi)
    {
        forAll(shape_.springs(), springi)
        {
            const scalar state =
                springStates_.size() ? springStates_(springi, copyi) : 0;
            const scalar relaxed = shape_.law().relaxedLength
            (
                shape_.restLengths()[springi],
                state
            );
            energy += 0.5*shape_.springConstants()[springi]
               *sqr(springLength(springi, copyi) - relaxed);
        }
        addElementTerms(copyi, energy, nullptr);
    }
    return energy;
}


Foam::scalar Foam::fsi::bodyGroup::volume(const label copyi) const
{
    return bodyResponse::area(shape_, positions_, copyi);
}


Foam::point Foam::fsi::bodyGroup::centroid(const label copyi) const
{
    return massAverage(positions_, copyi);
}


Foam::vector Foam::fsi::bodyGroup::velocity(const label copyi) const
{
    return massAverage(velocities_, copyi);
}


Foam::vector Foam::fsi::bodyGroup::momentum(const label copyi) const
{
    return sum(shape_.nodeMasses())*velocity(copyi);
}


Foam::vector Foam::fsi::bodyGroup::angularMomentum(const label copyi) const
{
    const point centre(centroid(copyi));
    vector sum(Zero);
    forAll(shape_.nodeMasses(), nodei)
    {
        const scalar x = positions_(nodei, 2*copyi) - centre.x();
        const scalar y = positions_(nodei, 2*copyi + 1) - centre.y();
        sum.z() += shape_.nodeMasses()[nodei]
           *(
                x*velocities_(nodei, 2*copyi + 1)
              - y*velocities_(nodei, 2*copyi)
            );
    }
    return sum;
}


Foam::vector Foam::fsi::bodyGroup::angularVelocity(const label copyi) const
{
    const point centre(centroid(copyi));
    scalar inertia = 0;
    forAll(shape_.nodeMasses(), nodei)
    {
        const scalar x = positions_(nodei, 2*copyi) - centre.x();
        const scalar y = positions_(nodei, 2*copyi + 1) - centre.y();
        inertia += shape_.nodeMasses()[nodei]*(x*x + y*y);
    }
    return angularMomentum(copyi)/inertia;
}


// ************************************************************************* //
