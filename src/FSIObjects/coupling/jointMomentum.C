// SPDX-License-Identifier: GPL-3.0-or-later

#include "viscousCoupling.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

typedef viscousCoupling::components components;

//- Scalar product over all directions and ranks
static scalar dot(const components& a, const components& b)
{
    scalar sum = 0;
    forAll(a, d)
    {
        sum += sumProd(a[d], b[d]);
    }
    return returnReduce(sum, sumOp<scalar>());
}


//- y += s x
static void add(components& y, const scalar s, const components& x)
{
    forAll(y, d)
    {
        y[d] += s*x[d];
    }
}


//- y = x + s y
static void scaleAdd(components& y, const scalar s, const components& x)
{
    forAll(y, d)
    {
        y[d] = x[d] + s*y[d];
    }
}


//- y = x/diagonal
static void precondition
(
    components& y,
    const components& x,
    const components& diagonal
)
{
    forAll(y, d)
    {
        y[d] = x[d]/diagonal[d];
    }
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::viscousCoupling::setMatrix(components& source)
{
    const fvVectorMatrix& UEqn = *UEqn_;
    const lduAddressing& addressing = UEqn.lduAddr();
    const label nDims = system_.grid.nDims();

    diagonal_.setSize(nDims);
    source.setSize(nDims);
    forAll(source, d)
    {
        diagonal_[d] = UEqn.diag();
        source[d] = UEqn.source().component(d);

        forAll(UEqn.internalCoeffs(), patchi)
        {
            const labelUList& cells = addressing.patchAddr(patchi);
            const scalarField coeffs
            (
                UEqn.internalCoeffs()[patchi].component(d)
            );
            forAll(cells, i)
            {
                diagonal_[d][cells[i]] += coeffs[i];
            }
            if (!UEqn.psi().boundaryField()[patchi].coupled())
            {
                const scalarField values
                (
                    UEqn.boundaryCoeffs()[patchi].component(d)
                );
                forAll(cells, i)
                {
                    source[d][cells[i]] += values[i];
                }
            }
        }
        for (const wallLink& link : system_.geometry.wallLinks())
        {
            diagonal_[d][link.cell] += system_.viscosity*link.conductance;
        }
    }
}


void Foam::fsi::viscousCoupling::multiply
(
    const components& u,
    components& y
) const
{
    fvVectorMatrix& UEqn = *UEqn_;
    const lduInterfaceFieldPtrsList interfaces
    (
        UEqn.psi().boundaryField().scalarInterfaces()
    );

    // The matrix's own diagonal has neither patches nor links: exchanged for
    // the duration of the product
    scalarField& matrixDiagonal = UEqn.diag();
    forAll(u, d)
    {
        FieldField<Field, scalar> bouCoeffs
        (
            UEqn.boundaryCoeffs().component(d)
        );
        y[d].setSize(u[d].size());
        matrixDiagonal.swap(const_cast<scalarField&>(diagonal_[d]));
        UEqn.Amul(y[d], u[d], bouCoeffs, interfaces, d);
        matrixDiagonal.swap(const_cast<scalarField&>(diagonal_[d]));
    }

    groupVelocity_.setSize(responses_.size());
    nodeVelocity(u, false, groupVelocity_);
    system_.objects.toSurface(groupVelocity_, nodalVelocity_);
    for (const wallLink& link : system_.geometry.wallLinks())
    {
        const vector wall(link.place.interpolate(nodalVelocity_));
        forAll(y, d)
        {
            y[d][link.cell] -= system_.viscosity*link.conductance*wall[d];
        }
    }
}


Foam::label Foam::fsi::viscousCoupling::iterate
(
    components& u,
    const components& source,
    const dictionary& controls,
    scalar& initialResidual,
    scalar& finalResidual
) const
{
    const scalar tolerance =
        controls.lookupOrDefault<scalar>("tolerance", 1e-7);
    const scalar relTol = controls.lookupOrDefault<scalar>("relTol", 0);
    const label maxIter = controls.lookupOrDefault<label>("maxIter", 1000);

    components r(source), p(source), v(source), s(source), t(source);
    components pHat(source), sHat(source);

    multiply(u, r);
    scaleAdd(r, -1, source);
    const components shadow(r);

    const scalar norm = Foam::sqrt(dot(source, source)) + VSMALL;
    initialResidual = Foam::sqrt(dot(r, r))/norm;
    finalResidual = initialResidual;
    const scalar target = max(tolerance, relTol*initialResidual);

    scalar rho = 1, alpha = 1, omega = 1;
    label n = 0;
    for (; n < maxIter && finalResidual > target; ++n)
    {
        const scalar rhoOld = rho;
        rho = dot(shadow, r);
        if (n == 0)
        {
            p = r;
        }
        else
        {
            add(p, -omega, v);
            scaleAdd(p, rho/rhoOld*alpha/omega, r);
        }
        precondition(pHat, p, diagonal_);
        multiply(pHat, v);
        alpha = rho/dot(shadow, v);

        s = r;
        add(s, -alpha, v);
        precondition(sHat, s, diagonal_);
        multiply(sHat, t);
        omega = dot(t, s)/max(dot(t, t), VSMALL);

        add(u, alpha, pHat);
        add(u, omega, sHat);
        r = s;
        add(r, -omega, t);
        finalResidual = Foam::sqrt(dot(r, r))/norm;
    }
    return n;
}


// ************************************************************************* //
