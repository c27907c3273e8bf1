// SPDX-License-Identifier: GPL-3.0-or-later

#include "valueSpread.H"
#include "dictionaryCheck.H"
#include "errorOf.H"

#include <cmath>
#include <functional>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- The place between two where a function that falls becomes 0
static scalar rootBetween
(
    scalar low,
    scalar high,
    const std::function<scalar(const scalar)>& falling
)
{
    for (label i = 0; i < 200; ++i)
    {
        const scalar middle = 0.5*(low + high);
        (falling(middle) > 0 ? low : high) = middle;
    }
    return 0.5*(low + high);
}


//- Standard deviation
static scalar deviationOf(const scalarField& values)
{
    return std::sqrt(average(sqr(values - average(values))));
}


//- Values with the mean 0 and the deviation 1
static scalarField standard(const scalarField& values)
{
    const scalar deviation = deviationOf(values);
    return (values - average(values))/max(deviation, VSMALL);
}


//- Middles of classes of equal probability, of a uniform distribution
static scalarField evenly(const label n)
{
    scalarField values(n);
    forAll(values, i)
    {
        values[i] = (i + 0.5)/n;
    }
    return values;
}


//- Standard normal values
static scalarField normals(const label n)
{
    scalarField values(evenly(n));
    for (scalar& value : values)
    {
        const scalar above = 1 - value;
        value = rootBetween(-40, 40, [&](const scalar x)
        {
            return 0.5*std::erfc(x/std::sqrt(2.0)) - above;
        });
    }
    return standard(values);
}


//- Log-normal values of a mean and a deviation
static scalarField logNormals
(
    const dictionary& dict,
    const label n,
    const scalar mean,
    const scalar deviation
)
{
    const scalarField z(normals(n));
    const auto values = [&](const scalar s)
    {
        const scalarField v(exp(s*z - s*max(z)));
        return scalarField(mean/average(v)*v);
    };
    const scalar most = 20;
    if (!(deviationOf(values(most)) > deviation))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'deviation' in dictionary " << dict.name() << " is "
            << deviation << " but " << n << " classes cannot have more than "
            << deviationOf(values(most)) << " (entry 'classes')"
            << exit(FatalIOError);
    }
    return values(rootBetween(0, most, [&](const scalar s)
    {
        return deviation - deviationOf(values(s));
    }));
}


//- The values of a list, each as often as its weight says
static scalarField listed(const dictionary& dict, const label n)
{
    checkKeys(dict, {"type", "values", "weights"});
    const scalarField values(readEntry<scalarField>(dict, "values"));
    const scalarField weights
    (
        dict.found("weights")
      ? readEntry<scalarField>(dict, "weights")
      : scalarField(values.size(), scalar(1))
    );
    scalar total = 0;
    for (const scalar weight : weights)
    {
        total += weight >= 0 ? weight : -GREAT;
    }
    if (values.empty() || weights.size() != values.size() || !(total > 0))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'weights' in dictionary " << dict.name() << " has "
            << weights.size() << " numbers but must have one >= 0, not all 0,"
            << " for each of the " << values.size() << " in 'values'"
            << exit(FatalIOError);
    }
    scalarField result(evenly(n));
    for (scalar& value : result)
    {
        label i = 0;
        scalar sum = weights[0];
        while (i + 1 < values.size() && sum <= value*total)
        {
            sum += weights[++i];
        }
        value = values[i];
    }
    return result;
}


//- Values by the type
static scalarField valuesOf(const dictionary& dict, const label n)
{
    const word type
    (
        readChoice
        (
            dict, "type", word::null,
            {"uniform", "normal", "logNormal", "list"}
        )
    );
    if (type == "list")
    {
        return listed(dict, n);
    }
    if (type == "uniform")
    {
        checkKeys(dict, {"type", "min", "max"});
        const scalar least = readPositive(dict, "min");
        const scalar most = readPositive(dict, "max");
        if (most < least)
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'max' in dictionary " << dict.name() << " is "
                << most << " but must be at least 'min', " << least
                << exit(FatalIOError);
        }
        return
            0.5*(least + most)
          + (most - least)/std::sqrt(12.0)*standard(evenly(n));
    }
    checkKeys(dict, {"type", "mean", "deviation"});
    const scalar mean = readPositive(dict, "mean");
    const scalar deviation = readPositive(dict, "deviation");
    return
        type == "normal"
      ? scalarField(mean + deviation*normals(n))
      : logNormals(dict, n, mean, deviation);
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalarField Foam::fsi::valueSpread
(
    const dictionary& dict,
    const label nClasses
)
{
    const scalarField values(valuesOf(dict, nClasses));
    if (!(min(values) > 0))
    {
        FatalIOErrorInFunction(dict)
            << "Dictionary " << dict.name() << " gives the value "
            << min(values) << " but all must be > 0: take a smaller spread, or"
            << " the type logNormal" << exit(FatalIOError);
    }
    return values;
}


// ************************************************************************* //
