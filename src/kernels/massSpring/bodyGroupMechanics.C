// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyGroup.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Deformation gradient F of an element of a copy, row by row
static FixedList<scalar, 4> deformationGradient
(
    const shapeTemplate& shape,
    const label elementi,
    const Eigen::MatrixXd& positions,
    const label copyi
)
{
    const bodyElement& element = shape.elements()[elementi];
    const scalar* E = &shape.elementTerm().edges()[4*elementi];
    const scalar* B = &shape.elementTerm().inverseEdges()[4*elementi];

    FixedList<scalar, 4> F;
    for (label i = 0; i < 2; ++i)
    {
        const auto x = positions.col(2*copyi + i);
        const scalar d1 = x[element[1]] - x[element[0]] - E[i];
        const scalar d2 = x[element[2]] - x[element[0]] - E[2 + i];
        F[2*i] = d1*B[0] + d2*B[2] + scalar(i == 0);
        F[2*i + 1] = d1*B[1] + d2*B[3] + scalar(i == 1);
    }
    return F;
}

} // End namespace fsi
} // End namespace Foam


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

    const volumeTerm& term = shape_.elementTerm();
    forAll(shape_.elements(), elementi)
    {
        FixedList<scalar, 4> F
        (
            deformationGradient(shape_, elementi, positions_, copyi)
        );
        const scalar volume = term.volumes()[elementi];
        const scalar stiffness = term.stiffness()*volume;
        const scalar shear = 2*shape_.shearModulus()*volume;

        // The part that is not conformal is (c d; d -c)
        const scalar c = 0.5*(F[0] - F[3]);
        const scalar d = 0.5*(F[1] + F[2]);
        energy +=
            0.25*stiffness*sqr(F[0]*F[3] - F[1]*F[2] - 1)
          + shear*(sqr(c) + sqr(d));
        if (force)
        {
            volumeTerm::toGradient(F[0], F[1], F[2], F[3]);
            const scalar pull[4] =
            {
                -stiffness*F[0] - shear*c,
                -stiffness*F[1] - shear*d,
                -stiffness*F[2] - shear*d,
                -stiffness*F[3] + shear*c
            };
            auto f = force->middleCols(2*copyi, 2);
            const bodyElement& element = shape_.elements()[elementi];
            const scalar* B = &term.inverseEdges()[4*elementi];
            for (label i = 0; i < 2; ++i)
            {
                const scalar h1 = pull[2*i]*B[0] + pull[2*i + 1]*B[1];
                const scalar h2 = pull[2*i]*B[2] + pull[2*i + 1]*B[3];
                f(element[0], i) -= h1 + h2;
                f(element[1], i) += h1;
                f(element[2], i) += h2;
            }
        }
    }
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
